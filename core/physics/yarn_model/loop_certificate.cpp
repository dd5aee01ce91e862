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

/// Through the fan from `centre` to the rim.
int piercings(std::span<const Eigen::Vector3d> way, const Points& rim, const Eigen::Vector3d& centre) {
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

/// Any filling of the rim will do, and a fan may fold where the rim is much bent: so three are tried, from
/// its middle and from half a diameter before and behind it. `found` is what the first one showed.
bool certified(const Points& own, const Points& rim, int face, double diameter, LoopFault& found) {
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& p : rim) {
        middle += p / static_cast<double>(rim.size());
    }
    const std::span<const Eigen::Vector3d> all(own);
    const std::size_t head = own.size() / 2;
    for (const double depth : {0.0, 0.5, -0.5}) {
        const Eigen::Vector3d centre = middle + Eigen::Vector3d(0, 0, depth * diameter);
        // A loop runs from left to right, so seen from the front its rim turns clockwise.
        const int left = -piercings(all.first(head + 1), rim, centre);
        const int right = -piercings(all.subspan(head), rim, centre);
        if (left == face && right == -face) {
            return true;
        }
        if (depth == 0) {
            found.leftPiercings = left;
            found.rightPiercings = right;
        }
    }
    return false;
}

} // namespace

std::vector<LoopFault> findLoopFaults(const KnitPurl& pattern, const YarnChains& chains, const Vector& x,
                                      int perLoop) {
    std::vector<LoopFault> faults;
    for (int course = 0; course < pattern.courses; ++course) {
        for (int wale = 0; wale < pattern.wales; ++wale) {
            const Points below = loopPoints(pattern, chains, x, perLoop, wale, course - 1);
            const Points own = loopPoints(pattern, chains, x, perLoop, wale, course);
            LoopFault found{wale, course, 0, 0};
            if (!certified(own, below, pattern.at(wale, course), chains.yarns.front().outerDiameter, found)) {
                faults.push_back(found);
            }
        }
    }
    return faults;
}

} // namespace knittsim::physics
