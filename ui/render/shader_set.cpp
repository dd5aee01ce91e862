#include "ui/render/shader_set.h"

#include <vector>

namespace knittsim::render {

Result<ShaderSet> loadShaders() {
    struct Wanted {
        std::unique_ptr<ShaderProgram>& program;
        std::vector<const char*> vertex;
        std::vector<const char*> fragment;
    };
    ShaderSet set;
    const std::vector<const char*> tube{"nodes.glsl", "tube.vert"};
    const std::vector<const char*> band{"band_place.glsl", "nodes.glsl", "band.vert"};
    const std::vector<const char*> ridge{"ridge.glsl", "nodes.glsl", "tube.vert"};
    for (const Wanted& wanted :
         {Wanted{set.pliedTube, tube, {"surface.glsl", "tube.glsl", "plies.glsl", "yarn.frag"}},
          {set.pliedRidge, ridge, {"ridge.glsl", "surface.glsl", "tube.glsl", "plies.glsl", "yarn.frag"}},
          {set.yarnTube, tube, {"surface.glsl", "tube.glsl", "no_plies.glsl", "yarn.frag"}},
          {set.yarnRidge, ridge, {"ridge.glsl", "surface.glsl", "tube.glsl", "no_plies.glsl", "yarn.frag"}},
          {set.yarnBand,
           band,
           {"band_place.glsl", "surface.glsl", "band.glsl", "no_plies.glsl", "yarn.frag"}},
          {set.cutTube,
           {"cut.glsl", "nodes.glsl", "tube.vert"},
           {"cut.glsl", "surface.glsl", "tube.glsl", "plies.glsl", "cut_face.glsl", "yarn.frag"}},
          {set.hair, {"nodes.glsl", "hair.vert"}, {"surface.glsl", "hair.frag"}},
          {set.strokesTube, tube, {"surface.glsl", "tube.glsl", "strokes.frag"}},
          {set.strokesRidge, ridge, {"ridge.glsl", "surface.glsl", "tube.glsl", "strokes.frag"}},
          {set.strokesBand, band, {"band_place.glsl", "surface.glsl", "band.glsl", "strokes.frag"}},
          {set.line, band, {"band_place.glsl", "surface.glsl", "band.glsl", "line.frag"}},
          {set.marker, {"marker.vert"}, {"marker.frag"}},
          {set.background, {"background.vert"}, {"background.frag"}}}) {
        auto loaded = ShaderProgram::load(wanted.vertex, wanted.fragment);
        if (!loaded) {
            return Result<ShaderSet>::failure(loaded.diagnostics());
        }
        wanted.program = std::move(loaded.value());
    }
    return set;
}

} // namespace knittsim::render
