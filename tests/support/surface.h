#pragma once

#include "core/base/vec3.h"

#include <Eigen/Geometry>

#include <cstdint>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace knittsim::test {

/// Triangles, three places each.
struct Surface {
    std::vector<Vec3f> places;
    std::vector<Vec3f> normals; ///< by place
    std::vector<std::uint32_t> corners;
};

/// Every edge belongs to two triangles that run along it in opposite directions.
inline bool isClosed(const Surface& surface) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> ways;
    for (std::size_t t = 0; t + 2 < surface.corners.size(); t += 3) {
        for (std::size_t k = 0; k < 3; ++k) {
            ++ways[{surface.corners[t + k], surface.corners[t + (k + 1) % 3]}];
        }
    }
    for (const auto& [way, count] : ways) {
        const auto back = ways.find({way.second, way.first});
        if (count != 1 || back == ways.end() || back->second != 1) {
            return false;
        }
    }
    return true;
}

/// Places - edges + triangles: 2 for a sphere, 0 for a ring.
inline long eulerNumber(const Surface& surface) {
    const std::set<std::uint32_t> used(surface.corners.begin(), surface.corners.end());
    const auto triangles = static_cast<long>(surface.corners.size() / 3);
    return static_cast<long>(used.size()) - triangles * 3 / 2 + triangles;
}

/// Positive when the triangles look outwards, mm^3.
inline double volumeOf(const Surface& surface) {
    double six = 0;
    for (std::size_t t = 0; t + 2 < surface.corners.size(); t += 3) {
        const Vec3 a = surface.places[surface.corners[t]].cast<double>();
        const Vec3 b = surface.places[surface.corners[t + 1]].cast<double>();
        const Vec3 c = surface.places[surface.corners[t + 2]].cast<double>();
        six += a.dot(b.cross(c));
    }
    return six / 6;
}

} // namespace knittsim::test
