#include "core/fabric/fabric_builder.h"

#include "core/fabric/course_numbers.h"
#include "core/fabric/entry_table.h"
#include "core/fabric/leg_crossings.h"
#include "core/fabric/machine_shape.h"
#include "core/fabric/strand_tracker.h"
#include "core/fabric/yarn_threader.h"

#include <algorithm>

namespace knittsim::fabric {

namespace {

/// Loops as the fabric knows them, without their points yet.
std::vector<Loop> fatesToLoops(const machine::LoopTable& made, const StrandTracker& tracker,
                               const CourseNumbers& courses) {
    std::vector<Loop> loops(made.loops.size());
    for (std::size_t i = 0; i < loops.size(); ++i) {
        const StrandTracker::Fate& fate = tracker.fates()[i];
        loops[i].course = courses.courseOf(made.loops[i].operation);
        loops[i].bound = fate.needle;
        loops[i].boundRack = fate.rack;
        loops[i].end = fate.end;
    }
    return loops;
}

/// The next loop comes through all heads of a needle at once, so these heads are one place.
void joinHeads(const machine::LoopTable& made, const machine::MachineState& end, EntryTable& entries) {
    const auto join = [&](std::span<const LoopIndex> stack) {
        for (std::size_t k = 1; k < stack.size(); ++k) {
            entries.join(EntryTable::head(stack[0], Side::Left), EntryTable::head(stack[k], Side::Left));
            entries.join(EntryTable::head(stack[0], Side::Right), EntryTable::head(stack[k], Side::Right));
        }
    };
    for (std::size_t i = 0; i < made.loops.size(); ++i) {
        join(made.parentsOf(static_cast<LoopIndex>(i)));
    }
    for (const machine::NeedleRow& row : end.beds) {
        for (std::int32_t needle = row.first(); needle < row.end(); ++needle) {
            join(row.at(needle));
        }
    }
}

void indexEntries(Fabric& fabric) {
    fabric.firstOfEntry.assign(static_cast<std::size_t>(fabric.entryCount) + 1, 0);
    for (const BondingPoint& point : fabric.points) {
        ++fabric.firstOfEntry[static_cast<std::size_t>(point.entry) + 1];
    }
    for (std::size_t e = 1; e < fabric.firstOfEntry.size(); ++e) {
        fabric.firstOfEntry[e] += fabric.firstOfEntry[e - 1];
    }
    fabric.pointsOfEntry.resize(fabric.points.size());
    std::vector<std::int32_t> next(fabric.firstOfEntry.begin(), fabric.firstOfEntry.end() - 1);
    for (std::size_t p = 0; p < fabric.points.size(); ++p) {
        const auto slot = next[static_cast<std::size_t>(fabric.points[p].entry)]++;
        fabric.pointsOfEntry[static_cast<std::size_t>(slot)] = static_cast<PointIndex>(p);
    }
}

} // namespace

Fabric buildFabric(const machine::Timeline& timeline, OperationIndex count) {
    const OperationIndex all = timeline.operationCount();
    const OperationIndex wanted = count < 0 ? all : std::min(count, all);
    machine::Emulator emulator(timeline.program(), timeline.profile());
    StrandTracker tracker(emulator, timeline.program());
    while (emulator.state().nextOperation < wanted) {
        emulator.step(&tracker);
    }

    Fabric fabric;
    fabric.pitchMm = timeline.profile().pitchMm();
    fabric.made = emulator.takeLoops();
    const CourseNumbers courses = numberCourses(timeline);
    fabric.loops = fatesToLoops(fabric.made, tracker, courses);
    for (const Loop& loop : fabric.loops) {
        fabric.courseCount = std::max(fabric.courseCount, loop.course + 1);
    }

    EntryTable entries(fabric.loops.size());
    joinHeads(fabric.made, emulator.state(), entries);
    const LegCrossings crossings(tracker, fabric.loops.size());
    threadYarns(fabric, courses, crossings, entries);
    indexEntries(fabric);
    layOutOnMachine(fabric, timeline.profile());
    return fabric;
}

} // namespace knittsim::fabric
