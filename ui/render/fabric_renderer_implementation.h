#pragma once

#include "ui/render/buffer_texture.h"
#include "ui/render/fabric_renderer.h"
#include "ui/render/level_of_detail.h"
#include "ui/render/shader_set.h"
#include "ui/render/tube_indices.h"

#include <epoxy/gl.h>

#include <utility>
#include <vector>

namespace knittsim::render {

/// The parts of FabricRenderer that no caller sees; its sources share them.
struct FabricRenderer::Implementation {
    std::string renderer, version;
    ShaderSet shaders;
    TubeIndices tubes;
    BufferTexture nodes{GL_RGBA32F}, surface{GL_RG32UI}, hidden{GL_RGBA8}, owner{GL_R32UI}, state{GL_R8UI};
    GLuint noise = 0;
    GLuint emptyArray = 0; ///< core profile draws nothing without an array object
    GLuint markerArray = 0;
    GLuint markerBuffer = 0;
    GLint mostTexels = 0;

    std::shared_ptr<const SceneFrame> frame;
    std::shared_ptr<const SceneTopology> topology;
    std::vector<YarnLook> looks;
    std::vector<machine::LoopIndex> selection;
    machine::LoopIndex hovered = -1;
    bool stateDirty = true;
    std::size_t carriers = 0;
    std::vector<GLint> firsts; ///< of the pieces to draw
    std::vector<const void*> offsets;
    std::vector<GLsizei> counts;

    ~Implementation() {
        glDeleteTextures(1, &noise);
        glDeleteVertexArrays(1, &emptyArray);
        glDeleteVertexArrays(1, &markerArray);
        glDeleteBuffers(1, &markerBuffer);
    }

    void makeNoise();
    void makeArrays();
    void setTopology(std::shared_ptr<const SceneTopology> next);
    void uploadState();
    bool anyState() const { return hovered >= 0 || !selection.empty(); }
    const YarnLook& look(std::size_t carrier) const;

    void drawBackground(const View& view) const;
    void drawYarns(const View& view);
    void drawCarrier(const View& view, const Frustum& frustum, machine::CarrierIndex carrier);
    void drawHair(const View& view, const Frustum& frustum, machine::CarrierIndex carrier, float radius,
                  float grown) const;
    const ShaderProgram& programFor(const Detail& detail, bool cut) const;
    void collectPieces(const Frustum& frustum, machine::CarrierIndex carrier, float radius,
                       const Detail& detail);
    void setCamera(const ShaderProgram& program, const View& view) const;
    void setYarn(const ShaderProgram& program, const View& view, const YarnLook& look, float radius) const;
    void setRamp(const ShaderProgram& program) const;
    void drawMarkers(const View& view) const;
};

/// Colours as the screen shows them, 0 .. 1.
Vec3f shown(yarn::Colour c);

/// Lower and upper colour of the background.
std::pair<Vec3f, Vec3f> lowerAndUpper(bool dark);

} // namespace knittsim::render
