#pragma once

#include <Eigen/Core>

namespace knittsim {

/// Coordinates of the fabric: x along a course towards higher needle numbers, y along a wale towards later
/// courses, z towards a viewer who looks at the front bed. Unit mm.
using Vec3 = Eigen::Vector3d;
using Vec3f = Eigen::Vector3f;

} // namespace knittsim
