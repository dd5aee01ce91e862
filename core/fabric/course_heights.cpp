#include "core/fabric/course_heights.h"

#include "core/fabric/machine_shape.h"

#include <algorithm>
#include <cmath>

namespace knittsim::fabric {

namespace {

constexpr double kPlainShare = 0.18; ///< of the loop length: what is left of a leg between its bonding points
constexpr double kWithFloats = 1.5;  ///< heights of a plain course
constexpr double kWithMoves = 1.95;
constexpr double kMoved = 0.5; ///< pitches

double plainHeight(const Fabric& fabric) {
    return kPlainShare * meanLoopLength(fabric);
}

} // namespace

LoopIndex latestLoop(const Fabric& fabric, OperationIndex operation) {
    const auto& made = fabric.made.loops;
    const auto after = std::ranges::upper_bound(made, operation, {}, &machine::Loop::operation);
    return static_cast<LoopIndex>(std::max<std::ptrdiff_t>(1, after - made.begin())) - 1;
}

CourseHeights::CourseHeights(const Fabric& fabric)
    : m_courseMm(plainHeight(fabric)), m_bottom(static_cast<std::size_t>(fabric.courseCount) + 1, 0) {
    std::vector<double> factor(static_cast<std::size_t>(fabric.courseCount), 1);
    const auto raise = [&](LoopIndex loop, double least) {
        double& f = factor[static_cast<std::size_t>(fabric.loops[static_cast<std::size_t>(loop)].course)];
        f = std::max(f, least);
    };
    for (std::size_t i = 0; i < fabric.loops.size(); ++i) {
        const machine::Loop& made = fabric.made.loops[i];
        const Loop& loop = fabric.loops[i];
        const double way = machine::positionPitches(loop.bound, loop.boundRack) -
                           machine::positionPitches(made.needle, made.rack);
        if (std::abs(way) >= kMoved) {
            raise(static_cast<LoopIndex>(i), kWithMoves);
        }
    }
    for (const Crossing& crossing : fabric.crossings) {
        for (const PointIndex p : {crossing.over, crossing.under}) {
            const BondingPoint& point = fabric.points[static_cast<std::size_t>(p)];
            if (point.piece != Piece::Float) {
                raise(point.loop, kWithFloats);
            }
        }
    }
    for (std::size_t c = 0; c < factor.size(); ++c) {
        m_bottom[c + 1] = m_bottom[c] + factor[c] * m_courseMm;
    }
}

double CourseHeights::at(double course) const {
    const double last = static_cast<double>(m_bottom.size()) - 1;
    if (course >= last) {
        return m_bottom.back() + (course - last) * m_courseMm;
    }
    const auto below = static_cast<std::size_t>(std::max(0.0, course));
    const double part = course - static_cast<double>(below);
    return (1 - part) * m_bottom[below] + part * m_bottom[below + 1];
}

} // namespace knittsim::fabric
