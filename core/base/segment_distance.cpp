#include "core/base/segment_distance.h"

#include <algorithm>

namespace knittsim {

/// Minimum of a convex quadratic on the unit square: inside, or on the better of the edges that its free
/// minimum along each line leads to.
ClosestPoints closestPoints(const Eigen::Vector3d& p0, const Eigen::Vector3d& p1, const Eigen::Vector3d& q0,
                            const Eigen::Vector3d& q1, double centring) {
    const Eigen::Vector3d u = p1 - p0;
    const Eigen::Vector3d v = q1 - q0;
    const Eigen::Vector3d w = p0 - q0;
    const double uu = u.squaredNorm() + centring;
    const double vv = v.squaredNorm() + centring;
    const double uv = u.dot(v);
    const double uw = u.dot(w) - 0.5 * centring;
    const double vw = v.dot(w) + 0.5 * centring;
    const auto ratio = [](double a, double b) { return b > 0 ? std::clamp(a / b, 0.0, 1.0) : 0.0; };

    ClosestPoints best;
    const double area = uu * vv - uv * uv;
    // Where the lines are parallel any s will do.
    best.s = area > 1e-14 * uu * vv ? std::clamp((uv * vw - vv * uw) / area, 0.0, 1.0) : 0.0;
    best.t = ratio(uv * best.s + vw, vv);
    best.s = ratio(uv * best.t - uw, uu);
    best.distance = (w + best.s * u - best.t * v).norm();
    return best;
}

} // namespace knittsim
