#pragma once

#include "ui/render/fabric_scene.h"

namespace knittsim::render {

/// How much of the sky other yarn hides from a place of a yarn, to first order: to a surface there that faces
/// along the unit vector n, about 0.25 * all + 0.5 * n . way. 0: nothing; where a surface touches
/// yarn that crosses it about 0.2.
struct HiddenSky {
    float all = 0;
    Vec3f way = Vec3f::Zero(); ///< to where it is hidden, as long as much is
};

/// By node of `frame`, whose nodes, diameters and yarns are known. Yarn farther away than a few diameters
/// hides nothing, nor does the yarn itself close by. 0 between two yarns.
std::vector<HiddenSky> hiddenSky(const SceneFrame& frame);

/// Fills SceneFrame::hidden; with what is usual in a fabric above kMostShaded nodes, which are seen from far.
void addHidden(SceneFrame& frame);
constexpr std::size_t kMostShaded = 1'000'000;

} // namespace knittsim::render
