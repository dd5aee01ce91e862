#include "core/geometry/linking_number.h"

#include <Eigen/Geometry>

#include <cmath>
#include <numbers>

namespace knittsim::geometry {

namespace {

/// Signed half of the solid angle of the triangle of three directions of any length.
double halfSolidAngle(const Vec3& a, const Vec3& b, const Vec3& c) {
    const double la = a.norm();
    const double lb = b.norm();
    const double lc = c.norm();
    return std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
}

} // namespace

double linkingNumber(std::span<const Vec3> a, std::span<const Vec3> b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const Vec3& a0 = a[i];
        const Vec3& a1 = a[(i + 1) % a.size()];
        for (std::size_t k = 0; k < b.size(); ++k) {
            const Vec3& b0 = b[k];
            const Vec3& b1 = b[(k + 1) % b.size()];
            const Vec3 p = b0 - a0;
            const Vec3 q = b0 - a1;
            const Vec3 r = b1 - a1;
            const Vec3 s = b1 - a0;
            sum += halfSolidAngle(p, q, r) + halfSolidAngle(r, s, p);
        }
    }
    return sum / (2 * std::numbers::pi);
}

} // namespace knittsim::geometry
