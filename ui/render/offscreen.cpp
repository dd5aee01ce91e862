#include "ui/render/offscreen.h"

#include "ui/render/egl_context.h"
#include "ui/render/fabric_renderer.h"
#include "ui/render/frame_target.h"

namespace knittsim::render {

namespace {

View viewOf(const RenderRequest& request, const geometry::Bounds& bounds) {
    View view;
    view.width = request.width;
    view.height = request.height;
    view.quality = Quality::Best;
    view.dark = request.dark;
    view.transparent = request.transparent;
    view.camera.setViewport(request.width, request.height);
    view.camera.setScene(bounds);
    if (request.camera) {
        view.camera.setState(*request.camera);
    } else {
        view.camera.look(request.side);
        view.camera.fit(bounds);
    }
    return view;
}

} // namespace

Result<Image> renderFabric(const RenderRequest& request) {
    const auto context = EglContext::create();
    if (!context) {
        return Result<Image>::failure(context.diagnostics());
    }
    const auto renderer = FabricRenderer::create();
    if (!renderer) {
        return Result<Image>::failure(renderer.diagnostics());
    }
    const auto target = FrameTarget::create(request.width, request.height);
    if (!target) {
        return Result<Image>::failure(target.diagnostics());
    }
    // The scene lives shorter than the request: it need not own the fabric.
    const std::shared_ptr<const fabric::Fabric> fabric(std::shared_ptr<void>(), request.fabric);
    FabricScene scene(fabric, request.looks, request.style);
    while (request.curves == nullptr && scene.improve()) {
    }
    const auto frame = request.curves != nullptr ? scene.prepareCurves(*request.curves, request.values)
                                                 : scene.prepare(request.positions, request.values);
    if (!renderer.value()->upload(frame)) {
        return Diagnostic{.id = "KS0404",
                          .place = {},
                          .arguments = {"the fabric has more nodes than the graphics driver takes"}};
    }
    renderer.value()->setLooks(request.looks);
    renderer.value()->setSelection(request.selection);
    target.value()->bind();
    renderer.value()->draw(viewOf(request, frame->bounds));
    return target.value()->read();
}

} // namespace knittsim::render
