#pragma once

#include "core/base/progress.h"
#include "core/fabric/fabric.h"
#include "core/geometry/yarn_curve.h"
#include "ui/render/camera.h"
#include "ui/render/fabric_renderer.h"
#include "ui/render/image.h"
#include "ui/render/look.h"
#include "ui/render/section.h"

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace knittsim::render {

class EglContext;

/// One picture of a fabric.
struct RenderRequest {
    const fabric::Fabric* fabric = nullptr;
    std::span<const float> positions; ///< 3 per entry, mm; empty: where the machine leaves them
    /// Curves with normal and height instead of positions; not for Mesh.
    const geometry::YarnCurves* curves = nullptr;
    std::span<const float> values; ///< told by colours: by node of `curves`, else by bonding point
    std::vector<YarnLook> looks;   ///< by carrier; missing ones get a default look
    DrawStyle style = DrawStyle::Yarn;
    ViewSide side = ViewSide::Front;
    std::optional<CameraState> camera; ///< instead of `side` and fitting the whole fabric
    std::vector<machine::LoopIndex> selection;
    std::optional<Section> section{};
    std::vector<bool> keep; ///< by bonding point: what is drawn; empty: all
    int width = 1280;
    int height = 800;
    bool hair = true; ///< see View
    std::optional<DetailLevel> level{};
    bool dark = false;        ///< background
    bool transparent = false; ///< no background
    int part = 2048;          ///< pixels; larger pictures are drawn part by part
    Progress progress{};
};

/// Draws pictures without a window or a display (EGL surfaceless), with one context for all of them. Stays on
/// the thread that made it.
class OffscreenPainter {
public:
    /// Errors: KS0401 (no OpenGL), KS0402 (too old), KS0403 (shaders).
    static Result<std::unique_ptr<OffscreenPainter>> create();
    ~OffscreenPainter();
    OffscreenPainter(const OffscreenPainter&) = delete;
    OffscreenPainter& operator=(const OffscreenPainter&) = delete;

    /// Errors: KS0009 (cancelled), KS0404 (size).
    Result<Image> draw(const RenderRequest& request);

private:
    OffscreenPainter();
    std::unique_ptr<EglContext> m_context; // first: it goes last
    std::unique_ptr<FabricRenderer> m_renderer;
};

/// One picture with a painter of its own, which is slow to start; errors as there.
Result<Image> renderFabric(const RenderRequest& request);

} // namespace knittsim::render
