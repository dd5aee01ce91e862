#pragma once

#include "ui/render/shader_program.h"

namespace knittsim::render {

/// All programs of the renderer.
struct ShaderSet {
    std::unique_ptr<ShaderProgram> pliedTube, pliedRidge;         ///< lit yarn near by
    std::unique_ptr<ShaderProgram> yarnTube, yarnRidge, yarnBand; ///< lit yarn without plies
    std::unique_ptr<ShaderProgram> cutTube; ///< lit yarn with filled faces where a section cuts it
    std::unique_ptr<ShaderProgram> hair;    ///< loose fibres around it
    std::unique_ptr<ShaderProgram> strokesTube, strokesRidge, strokesBand;
    std::unique_ptr<ShaderProgram> line, marker; ///< bare mesh
    std::unique_ptr<ShaderProgram> background;
};

/// Needs a current context. Errors: KS0001, KS0403.
Result<ShaderSet> loadShaders();

} // namespace knittsim::render
