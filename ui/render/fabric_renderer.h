#pragma once

#include "core/base/result.h"
#include "ui/render/camera.h"
#include "ui/render/fabric_scene.h"
#include "ui/render/look.h"
#include "ui/render/section.h"

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace knittsim::render {

/// Fast: as coarse as the size on the screen allows, for pictures in motion. Best: for pictures that stay.
enum class Quality : std::uint8_t { Fast, Best };

/// Everything of a picture but the fabric's shape.
struct View {
    Camera camera;
    int width = 1; ///< pixels of the picture
    int height = 1;
    int left = 0; ///< pixel of the picture at the framebuffer's lower left corner, which may be smaller
    int bottom = 0;
    Quality quality = Quality::Fast;
    std::optional<DetailLevel> level{}; ///< nothing: as the yarn's width on the screen asks
    std::optional<Section> section{};
    bool hair = true; ///< loose fibres of hairy yarn seen near by
    bool dark = false;
    bool transparent = false; ///< clear to nothing instead of painting a background
};

/// Draws a fabric into the framebuffer that is bound. All functions, the destructor included, need the OpenGL
/// context current that create() was called with.
class FabricRenderer {
public:
    /// Errors: KS0402 (older than OpenGL 3.3 core), KS0403 (a shader does not build).
    static Result<std::unique_ptr<FabricRenderer>> create();

    /// Whether the driver has reset the current context: nothing that was made in it is left.
    static bool contextIsLost();

    ~FabricRenderer();
    FabricRenderer(const FabricRenderer&) = delete;
    FabricRenderer& operator=(const FabricRenderer&) = delete;

    /// Sends a shape to the graphics memory. False, and nothing drawn from then on, when it is too large for
    /// it.
    bool upload(std::shared_ptr<const SceneFrame> frame);

    /// Forgets the shape; draw() then paints the background only.
    void clear();

    /// By carrier. Diameters count as drawn; curves keep the ones they were made for.
    void setLooks(std::vector<YarnLook> looks);

    /// Highlights loops; an empty list ends it.
    void setSelection(std::span<const machine::LoopIndex> loops);

    /// Highlights one loop more faintly, -1 for none.
    void setHovered(machine::LoopIndex loop);

    void draw(const View& view);

    const std::string& rendererName() const; ///< GL_RENDERER
    const std::string& versionText() const;  ///< GL_VERSION

private:
    FabricRenderer();
    struct Implementation;
    std::unique_ptr<Implementation> m;
};

} // namespace knittsim::render
