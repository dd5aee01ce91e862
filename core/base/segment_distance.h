#pragma once

#include <Eigen/Core>

namespace knittsim {

/// Closest points of two segments: p0 + s (p1 - p0) and q0 + t (q1 - q0), s and t in [0, 1].
struct ClosestPoints {
    double s = 0;
    double t = 0;
    double distance = 0;
};

/// Works for points and parallel segments too (one of many closest pairs then). With `centring` L > 0 the
/// pair that minimises |p(s) - q(t)|^2 + L ((s - 1/2)^2 + (t - 1/2)^2), which does not jump from end to end
/// where segments become parallel.
ClosestPoints closestPoints(const Eigen::Vector3d& p0, const Eigen::Vector3d& p1, const Eigen::Vector3d& q0,
                            const Eigen::Vector3d& q1, double centring = 0);

} // namespace knittsim
