#include "core/fabric/machine_shape.h"

#include "core/fabric/course_heights.h"
#include "core/fabric/crossing_places.h"
#include "core/fabric/wale_places.h"

#include <algorithm>

namespace knittsim::fabric {

namespace {

constexpr double kGapInCourses = 0.6;

/// By loop: how high its heads lie, in courses. A held loop stretches up to the loop that comes through it,
/// or above the last yarn that passed it.
std::vector<std::int32_t> topCourses(const Fabric& fabric) {
    std::vector<std::int32_t> tops;
    tops.reserve(fabric.loops.size());
    for (const Loop& loop : fabric.loops) {
        tops.push_back(loop.end == Loop::End::Bound ? loop.course : loop.course + 1);
    }
    for (std::size_t i = 0; i < fabric.loops.size(); ++i) {
        for (const LoopIndex parent : fabric.made.parentsOf(static_cast<LoopIndex>(i))) {
            std::int32_t& top = tops[static_cast<std::size_t>(parent)];
            top = std::max(top, fabric.loops[i].course);
        }
    }
    for (const Crossing& crossing : fabric.crossings) {
        const auto latest = static_cast<std::size_t>(latestLoop(fabric, crossing.operation));
        const std::int32_t met = fabric.loops[latest].course;
        for (const PointIndex p : {crossing.over, crossing.under}) {
            const BondingPoint& point = fabric.points[static_cast<std::size_t>(p)];
            const auto loop = static_cast<std::size_t>(point.loop);
            if (point.piece != Piece::Float && fabric.loops[loop].end != Loop::End::Bound) {
                tops[loop] = std::max(tops[loop], met + 1);
            }
        }
    }
    return tops;
}

void placeHeads(Fabric& fabric, const machine::MachineProfile& profile, const CourseHeights& heights,
                const std::vector<WalePlace>& wales) {
    // Below the beds the take-down draws the two sides together.
    const double gap = std::min(profile.bedGapMm, kGapInCourses * heights.courseMm());
    const std::vector<std::int32_t> tops = topCourses(fabric);
    for (std::size_t i = 0; i < fabric.loops.size(); ++i) {
        const Loop& loop = fabric.loops[i];
        const double z = (machine::isFront(loop.bound.bed) ? 0.5 : -0.5) * gap;
        for (const auto& [point, side] : {std::pair{loop.headLeft, -1.0}, {loop.headRight, 1.0}}) {
            Vec3& place = fabric.machinePositions[static_cast<std::size_t>(
                fabric.points[static_cast<std::size_t>(point)].entry)];
            // Heads that share a place lie at the height of the highest there.
            const double y = std::max(place.y(), heights.at(tops[i]));
            place = {(wales[i].centre + side * wales[i].halfWidth) * fabric.pitchMm, y, z};
        }
    }
}

} // namespace

void layOutOnMachine(Fabric& fabric, const machine::MachineProfile& profile) {
    fabric.machinePositions.assign(static_cast<std::size_t>(fabric.entryCount), Vec3::Zero());
    const CourseHeights heights(fabric);
    fabric.courseMm = heights.courseMm();
    const WalePlaces wales = walePlaces(fabric);
    placeHeads(fabric, profile, heights, wales.bound);
    placeCrossings(fabric, heights, wales.made);
}

std::vector<float> machinePlaces(const Fabric& fabric) {
    std::vector<float> places;
    places.reserve(3 * fabric.machinePositions.size());
    for (const Vec3& place : fabric.machinePositions) {
        for (Eigen::Index i = 0; i < 3; ++i) {
            places.push_back(static_cast<float>(place[i]));
        }
    }
    return places;
}

double meanLoopLength(const Fabric& fabric) {
    double sum = 0;
    for (const machine::Loop& loop : fabric.made.loops) {
        sum += loop.lengthMm;
    }
    return sum / static_cast<double>(std::max<std::size_t>(1, fabric.made.loops.size()));
}

} // namespace knittsim::fabric
