#pragma once

#include "core/base/vec3.h"

#include <Eigen/Core>

namespace knittsim::render {

/// A plane; what lies on the side of its normal is cut away.
struct Section {
    Vec3f point = Vec3f::Zero();   ///< mm
    Vec3f normal = Vec3f::UnitZ(); ///< unit, towards what is cut away

    bool cuts(const Vec3f& place) const { return normal.dot(place - point) > 0; }

    /// Its product with (x y z 1) is how far a place lies behind the plane, mm.
    Eigen::Vector4f plane() const { return {-normal.x(), -normal.y(), -normal.z(), normal.dot(point)}; }
};

} // namespace knittsim::render
