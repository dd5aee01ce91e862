#include "core/fabric/fabric_builder.h"

#include "core/fabric/course_numbers.h"
#include "core/fabric/entry_index.h"
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
        loops[i].crowded = fate.crowded;
    }
    return loops;
}

void markHeld(const machine::MachineState& end, std::vector<Loop>& loops) {
    for (const machine::NeedleRow& row : end.beds) {
        for (std::int32_t needle = row.first(); needle < row.end(); ++needle) {
            for (const LoopIndex loop : row.at(needle)) {
                Loop& held = loops[static_cast<std::size_t>(loop)];
                held.onNeedle = true;
                if (held.end == Loop::End::Held) {
                    held.boundRack = end.rack;
                }
            }
        }
    }
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
    markHeld(emulator.state(), fabric.loops);
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
