#include "ui/render/offscreen.h"

#include "ui/render/egl_context.h"
#include "ui/render/fabric_renderer.h"
#include "ui/render/frame_target.h"
#include "ui/render/scene_chunks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace knittsim::render {

namespace {

View viewOf(const RenderRequest& request, const geometry::Bounds& bounds) {
    View view;
    view.width = request.width;
    view.height = request.height;
    view.quality = Quality::Best;
    view.section = request.section;
    view.hair = request.hair;
    view.level = request.level;
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

/// As many nodes as the pixels of a stitch can show.
int samplesOf(const RenderRequest& request) {
    constexpr double kPixelsOfASample = 10;
    constexpr double kMost = 12;
    const double pixels = static_cast<double>(request.width) * request.height;
    const double loops = std::max(1.0, static_cast<double>(request.fabric->loops.size()));
    const double wanted = std::min(kMost, std::sqrt(pixels / loops) / kPixelsOfASample);
    return std::max(samplesFor(*request.fabric), static_cast<int>(wanted));
}

void copyInto(Image& picture, const Image& drawn, int left, int top) {
    for (int y = 0; y < drawn.height; ++y) {
        const auto to = 4 * (static_cast<std::ptrdiff_t>(top + y) * picture.width + left);
        std::copy_n(drawn.at(0, y), 4 * drawn.width, picture.pixels.begin() + to);
    }
}

Result<Image> drawInParts(FabricRenderer& renderer, View view, int part, const Progress& progress) {
    Image picture{view.width, view.height, {}};
    picture.pixels.resize(4 * static_cast<std::size_t>(view.width) * static_cast<std::size_t>(view.height));
    for (int top = 0; top < view.height; top += part) {
        for (view.left = 0; view.left < view.width; view.left += part) {
            const double rows = static_cast<double>(top) / view.height;
            const double columns = static_cast<double>(view.left) / view.width;
            if (progress && !progress(rows + columns * std::min(part, view.height - top) / view.height)) {
                return Diagnostic{.id = "KS0009", .place = {}, .arguments = {}};
            }
            const int width = std::min(part, view.width - view.left);
            const int height = std::min(part, view.height - top);
            const auto target = FrameTarget::create(width, height);
            if (!target) {
                return Result<Image>::failure(target.diagnostics());
            }
            view.bottom = view.height - top - height;
            target.value()->bind();
            renderer.draw(view);
            copyInto(picture, target.value()->read(), view.left, top);
        }
    }
    return picture;
}

} // namespace

OffscreenPainter::OffscreenPainter() = default;
OffscreenPainter::~OffscreenPainter() = default;

Result<std::unique_ptr<OffscreenPainter>> OffscreenPainter::create() {
    using R = Result<std::unique_ptr<OffscreenPainter>>;
    auto context = EglContext::create();
    if (!context) {
        return R::failure(context.diagnostics());
    }
    auto renderer = FabricRenderer::create();
    if (!renderer) {
        return R::failure(renderer.diagnostics());
    }
    std::unique_ptr<OffscreenPainter> painter(new OffscreenPainter);
    painter->m_context = std::move(context.value());
    painter->m_renderer = std::move(renderer.value());
    return painter;
}

Result<Image> OffscreenPainter::draw(const RenderRequest& request) {
    const int most = FrameTarget::mostPixels();
    if (std::min(request.width, request.height) < 1 || std::max(request.width, request.height) > most) {
        return Diagnostic{.id = "KS0404",
                          .place = {},
                          .arguments = {fmt::format("{} x {} pixels: the graphics driver takes 1 to {}",
                                                    request.width, request.height, most)}};
    }
    // The scene lives shorter than the request: it need not own the fabric.
    const std::shared_ptr<const fabric::Fabric> fabric(std::shared_ptr<void>(), request.fabric);
    FabricScene scene(fabric, request.looks, request.style, samplesOf(request));
    while (request.curves == nullptr && scene.improve()) {
    }
    auto frame = request.curves != nullptr ? scene.prepareCurves(*request.curves, request.values)
                                           : scene.prepare(request.positions, request.values);
    if (!request.keep.empty()) {
        frame = isolated(*frame, *fabric, request.keep);
    }
    if (!m_renderer->upload(frame)) {
        return Diagnostic{.id = "KS0404",
                          .place = {},
                          .arguments = {"the fabric has more nodes than the graphics driver takes"}};
    }
    m_renderer->setLooks(request.looks);
    m_renderer->setSelection(request.selection);
    return drawInParts(*m_renderer, viewOf(request, frame->bounds), request.part, request.progress);
}

Result<Image> renderFabric(const RenderRequest& request) {
    const auto painter = OffscreenPainter::create();
    if (!painter) {
        return Result<Image>::failure(painter.diagnostics());
    }
    return painter.value()->draw(request);
}

} // namespace knittsim::render
