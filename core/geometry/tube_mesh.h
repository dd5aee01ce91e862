#pragma once

#include "core/base/vec3.h"

#include <cstdint>
#include <span>
#include <vector>

namespace knittsim::geometry {

/// A closed surface of triangles; corners are counted against the clock when seen from outside.
struct TubeMesh {
    std::vector<Vec3f> places;            ///< mm
    std::vector<Vec3f> normals;           ///< by place, unit, outwards
    std::vector<std::uint32_t> triangles; ///< three places each
};

/// Part of the nodes of a curve, its ends among them: none of the others lies farther than `toleranceMm` from
/// the straight line that takes its place.
std::vector<Vec3f> thinned(std::span<const Vec3f> nodes, float toleranceMm);

/// A round tube about a curve with a dome at both ends: one surface without a hole, whose rings turn with
/// the curve as little as they can. Nodes that are not finite, or repeat the one before them, are left out;
/// with fewer than two others the mesh is empty. `sides` >= 3.
TubeMesh makeTube(std::span<const Vec3f> nodes, float radiusMm, int sides);

} // namespace knittsim::geometry
