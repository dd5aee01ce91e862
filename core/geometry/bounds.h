#pragma once

#include "core/base/vec3.h"

#include <limits>
#include <span>

namespace knittsim::geometry {

/// Axis-parallel box, mm. A fresh one is empty and grows with the points that are added.
struct Bounds {
    Vec3f low = Vec3f::Constant(std::numeric_limits<float>::infinity());
    Vec3f high = Vec3f::Constant(-std::numeric_limits<float>::infinity());

    bool empty() const { return !(low.array() <= high.array()).all(); }
    Vec3f centre() const { return 0.5F * (low + high); }
    Vec3f size() const { return high - low; }

    /// Points that are not finite are left out.
    void add(const Vec3f& point) {
        if (point.allFinite()) {
            low = low.cwiseMin(point);
            high = high.cwiseMax(point);
        }
    }
};

/// Box around `points`, wider by `margin` mm on every side.
inline Bounds boundsOf(std::span<const Vec3f> points, float margin = 0) {
    Bounds box;
    for (const Vec3f& point : points) {
        box.add(point);
    }
    if (!box.empty()) {
        box.low.array() -= margin;
        box.high.array() += margin;
    }
    return box;
}

} // namespace knittsim::geometry
