#include "core/physics/yarn_model/knit_cell.h"

#include <array>
#include <cmath>
#include <cstring>
#include <numbers>
#include <numeric>

namespace knittsim::physics {

namespace {

constexpr int kPointsPerLoop = 96;   ///< of the fine curve that is cut into nodes
constexpr double kBulge = 1.2;       ///< how far a loop is wider at its head than at its feet
constexpr double kHalfHeight = 0.85; ///< of a loop, in course spacings
constexpr double kDepth = 0.45;      ///< in yarn diameters

int wrap(int i, int n) {
    return ((i % n) + n) % n;
}

/// Depth of a loop's curve at t in [-pi, pi], from its head (0) over leg and foot to the middle of the
/// sinker.
double depth(const KnitPurl& pattern, int wale, int course, double t) {
    const int own = pattern.at(wale, course);
    const int above = pattern.at(wale, course + 1);
    const int neighbour = pattern.at(t < 0 ? wale - 1 : wale + 1, course);
    constexpr std::array<double, 6> kPlaces{0, 0.17, 0.38, 0.6, 0.8, 1};
    const std::array<double, 6> depths{-1.0 * above, -1.0 * above, 1.0 * above,
                                       1.0 * own,    -1.0 * own,   -0.5 * (own + neighbour)};
    const double place = std::abs(t) / std::numbers::pi;
    std::size_t i = 1;
    while (i + 1 < kPlaces.size() && place > kPlaces[i]) {
        ++i;
    }
    const double share = (place - kPlaces[i - 1]) / (kPlaces[i] - kPlaces[i - 1]);
    const double smooth = share * share * (3 - 2 * share);
    return depths[i - 1] + smooth * (depths[i] - depths[i - 1]);
}

/// Fine curve of one course, its end (the image of its begin) included.
Eigen::Matrix3Xd courseCurve(const KnitPurl& pattern, int course, double wale, double height,
                             double diameter) {
    const int count = pattern.wales * kPointsPerLoop;
    Eigen::Matrix3Xd points(3, count + 1);
    for (int i = 0; i <= count; ++i) {
        const int loop = i / kPointsPerLoop;
        const double t = 2 * std::numbers::pi * (i % kPointsPerLoop) / kPointsPerLoop - std::numbers::pi;
        points.col(i) << wale * (loop + 0.5 + (t + kBulge * std::sin(2 * t)) / (2 * std::numbers::pi)),
            height * (course + kHalfHeight * std::cos(t)),
            kDepth * diameter * depth(pattern, loop, course, t);
    }
    return points;
}

double lengthOf(const Eigen::Matrix3Xd& points) {
    return (points.rightCols(points.cols() - 1) - points.leftCols(points.cols() - 1)).colwise().norm().sum();
}

/// `count` pieces of equal length along the curve.
Eigen::Matrix3Xd evenly(const Eigen::Matrix3Xd& curve, int count) {
    Eigen::Matrix3Xd result(3, count + 1);
    const double step = lengthOf(curve) / count;
    double begin = 0;
    Eigen::Index piece = 0;
    double length = (curve.col(1) - curve.col(0)).norm();
    for (int i = 0; i < count; ++i) {
        while (piece + 2 < curve.cols() && begin + length < i * step) {
            begin += length;
            ++piece;
            length = (curve.col(piece + 1) - curve.col(piece)).norm();
        }
        result.col(i) =
            curve.col(piece) + (i * step - begin) / length * (curve.col(piece + 1) - curve.col(piece));
    }
    result.col(count) = curve.col(curve.cols() - 1);
    return result;
}

} // namespace

int KnitPurl::at(int wale, int course) const {
    return faces[static_cast<std::size_t>(wrap(course, courses) * wales + wrap(wale, wales))];
}

KnitPurl KnitPurl::fromRows(const std::vector<const char*>& rows) {
    KnitPurl pattern{static_cast<int>(std::strlen(rows.front())), static_cast<int>(rows.size()), {}};
    for (const char* row : rows) {
        for (const char* c = row; *c != 0; ++c) {
            pattern.faces.push_back(*c == 'p' ? -1 : 1);
        }
    }
    return pattern;
}

YarnChains knitCell(const KnitPurl& pattern, const std::vector<double>& loopLengths, const RodYarn& yarn,
                    const KnitCellStart& start) {
    const double total = std::accumulate(loopLengths.begin(), loopLengths.end(), 0.0);
    const double mean = total / (pattern.wales * pattern.courses);
    double wale = mean / start.widthFactor;
    double height = mean / start.heightFactor;
    const int perCourse = pattern.wales * start.nodesPerLoop;
    const auto courses = [&] {
        std::vector<Eigen::Matrix3Xd> result;
        for (int course = 0; course < pattern.courses; ++course) {
            result.push_back(
                evenly(courseCurve(pattern, course, wale, height, yarn.outerDiameter), perCourse));
        }
        return result;
    };
    std::vector<Eigen::Matrix3Xd> course = courses();
    // Depth does not scale, so a few rounds until the nodes are as far apart as the yarn is long.
    for (int round = 0; round < 20; ++round) {
        double length = 0;
        for (const Eigen::Matrix3Xd& c : course) {
            length += lengthOf(c);
        }
        wale *= total / length;
        height *= total / length;
        course = courses();
    }

    YarnChains chains;
    chains.yarns = {yarn};
    chains.cell = Eigen::Vector2d(pattern.wales * wale, pattern.courses * height);
    chains.nodes.resize(3, Eigen::Index{perCourse} * pattern.courses);
    for (int c = 0; c < pattern.courses; ++c) {
        const Entry first = c * perCourse;
        chains.nodes.middleCols(first, perCourse) = course[static_cast<std::size_t>(c)].leftCols(perCourse);
        chains.chains.push_back({first, perCourse, 0, true, 1, 0});
        const auto begin = loopLengths.begin() + c * pattern.wales;
        const double length = std::accumulate(begin, begin + pattern.wales, 0.0);
        chains.restLength.insert(chains.restLength.end(), static_cast<std::size_t>(perCourse),
                                 length / perCourse);
    }
    return chains;
}

} // namespace knittsim::physics
