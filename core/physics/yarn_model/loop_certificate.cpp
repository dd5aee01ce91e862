#include "core/physics/yarn_model/loop_certificate.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <cmath>
#include <span>

namespace knittsim::physics {

namespace {

using Points = std::vector<Eigen::Vector3d>;

/// +1 when the way from p to q goes through the triangle along its normal, -1 against it, 0 past it.
int piercing(const Eigen::Vector3d& p, const Eigen::Vector3d& q, const Eigen::Vector3d& a,
             const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
    const auto volume = [](const Eigen::Vector3d& u, const Eigen::Vector3d& v, const Eigen::Vector3d& w) {
        return u.cross(v).dot(w);
    };
    const double from = volume(b - a, c - a, p - a);
    const double to = volume(b - a, c - a, q - a);
    if ((from < 0) == (to < 0)) {
        return 0;
    }
    const Eigen::Vector3d d = q - p;
    const double first = volume(a - p, b - p, d);
    const double second = volume(b - p, c - p, d);
    const double third = volume(c - p, a - p, d);
    const bool inside = (first < 0) == (second < 0) && (second < 0) == (third < 0);
    return !inside ? 0 : (to > from ? 1 : -1);
}

int piercings(std::span<const Eigen::Vector3d> way, const Points& rim) {
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& p : rim) {
        centre += p / static_cast<double>(rim.size());
    }
    int sum = 0;
    for (std::size_t i = 0; i + 1 < way.size(); ++i) {
        for (std::size_t j = 0; j < rim.size(); ++j) {
            sum += piercing(way[i], way[i + 1], centre, rim[j], rim[(j + 1) % rim.size()]);
        }
    }
    return sum;
}

/// Nodes of a loop from sinker to sinker.
Points loopPoints(const KnitPurl& pattern, const YarnChains& chains, const Vector& x, int perLoop, int wale,
                  int course) {
    const int row = ((course % pattern.courses) + pattern.courses) % pattern.courses;
    const Chain& chain = chains.chains[static_cast<std::size_t>(row)];
    Points points;
    for (int i = 0; i <= perLoop; ++i) {
        const Place p = chain.place(wale * perLoop + i).shifted(0, (course - row) / pattern.courses);
        points.push_back(position(x, chains.cellEntry(), p));
    }
    return points;
}

} // namespace

std::vector<LoopFault> findLoopFaults(const KnitPurl& pattern, const YarnChains& chains, const Vector& x,
                                      int perLoop) {
    std::vector<LoopFault> faults;
    for (int course = 0; course < pattern.courses; ++course) {
        for (int wale = 0; wale < pattern.wales; ++wale) {
            // A loop runs from left to right, so seen from the front its rim turns clockwise.
            const Points below = loopPoints(pattern, chains, x, perLoop, wale, course - 1);
            const Points own = loopPoints(pattern, chains, x, perLoop, wale, course);
            const auto half = static_cast<std::size_t>(perLoop / 2 + 1);
            const std::span<const Eigen::Vector3d> all(own);
            const int left = -piercings(all.first(half), below);
            const int right = -piercings(all.subspan(half - 1), below);
            const int face = pattern.at(wale, course);
            if (left != face || right != -face) {
                faults.push_back({wale, course, left, right});
            }
        }
    }
    return faults;
}

} // namespace knittsim::physics
