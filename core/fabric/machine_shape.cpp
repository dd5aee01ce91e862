#include "core/fabric/machine_shape.h"

#include <algorithm>

namespace knittsim::fabric {

namespace {

/// Height of one course under take-down: the legs of a loop that spans a needle pitch.
double courseHeight(const Fabric& fabric) {
    double sum = 0;
    for (const machine::Loop& loop : fabric.made.loops) {
        sum += loop.lengthMm;
    }
    const double length = sum / static_cast<double>(std::max<std::size_t>(1, fabric.made.loops.size()));
    return std::clamp((length - fabric.pitchMm) / 2, 0.15 * length, 0.4 * length);
}

void placeHeads(Fabric& fabric, const machine::MachineProfile& profile, double height) {
    for (const Loop& loop : fabric.loops) {
        const double x = machine::positionPitches(loop.bound, loop.boundRack) * fabric.pitchMm;
        const double z = (machine::isFront(loop.bound.bed) ? 0.5 : -0.5) * profile.bedGapMm;
        for (const auto& [point, side] : {std::pair{loop.headLeft, -1.0}, {loop.headRight, 1.0}}) {
            Vec3& place = fabric.machinePositions[static_cast<std::size_t>(
                fabric.points[static_cast<std::size_t>(point)].entry)];
            // Heads that share a place lie at the height of the latest loop there.
            const double y = std::max(place.y(), (loop.course + 1) * height);
            place = {x + side * fabric.pitchMm / 4, y, z};
        }
    }
}

/// Adds the place of every crossing as its strand would have it, counted between the next heads or feet.
void placeCrossings(Fabric& fabric) {
    std::vector<PointIndex> run;
    const auto isCorner = [&](PointIndex p) {
        return fabric.points[static_cast<std::size_t>(p)].role != Role::Crossing;
    };
    const auto place = [&](PointIndex p) -> Vec3& {
        return fabric
            .machinePositions[static_cast<std::size_t>(fabric.points[static_cast<std::size_t>(p)].entry)];
    };
    for (const Yarn& yarn : fabric.yarns) {
        PointIndex before = -1;
        run.clear();
        for (PointIndex p = yarn.first; p < yarn.first + yarn.count; ++p) {
            if (!isCorner(p)) {
                run.push_back(p);
                continue;
            }
            for (std::size_t i = 0; i < run.size(); ++i) {
                const double t = static_cast<double>(i + 1) / static_cast<double>(run.size() + 1);
                const Vec3 from = before >= 0 ? place(before) : place(p);
                place(run[i]) += 0.5 * ((1 - t) * from + t * place(p));
            }
            run.clear();
            before = p;
        }
        for (const PointIndex p : run) {
            place(p) += 0.5 * place(before); // the last leg of a yarn that ends with a tuck
        }
    }
}

} // namespace

void layOutOnMachine(Fabric& fabric, const machine::MachineProfile& profile) {
    fabric.machinePositions.assign(static_cast<std::size_t>(fabric.entryCount), Vec3::Zero());
    placeHeads(fabric, profile, courseHeight(fabric));
    placeCrossings(fabric);
}

} // namespace knittsim::fabric
