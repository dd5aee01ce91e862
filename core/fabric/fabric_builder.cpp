#include "core/fabric/fabric_builder.h"

#include "core/fabric/course_numbers.h"
#include "core/fabric/entry_index.h"
#include "core/fabric/entry_table.h"
#include "core/fabric/leg_crossings.h"
#include "core/fabric/machine_shape.h"
#include "core/fabric/strand_tracker.h"
#include "core/fabric/yarn_threader.h"

#include <algorithm>
#include <numeric>

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

void numberStack(std::span<const LoopIndex> stack, std::vector<Loop>& loops) {
    for (std::size_t k = 0; k < stack.size(); ++k) {
        loops[static_cast<std::size_t>(stack[k])].stackPlace = static_cast<std::int32_t>(k);
    }
}

void placeInStacks(const machine::LoopTable& made, const machine::MachineState& end,
                   std::vector<Loop>& loops) {
    for (std::size_t i = 0; i < made.loops.size(); ++i) {
        const bool sameOperation = i > 0 && made.loops[i].operation == made.loops[i - 1].operation;
        loops[i].plating = sameOperation ? loops[i - 1].plating + 1 : 0;
        numberStack(made.parentsOf(static_cast<LoopIndex>(i)), loops);
    }
    for (const machine::NeedleRow& row : end.beds) {
        for (std::int32_t needle = row.first(); needle < row.end(); ++needle) {
            numberStack(row.at(needle), loops);
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

/// Loops are made in the order of time, so the lists are, too.
void listDrawnThrough(Fabric& fabric) {
    std::vector<std::int32_t>& first = fabric.firstThrough;
    first.assign(fabric.loops.size() + 1, 0);
    for (std::size_t i = 0; i < fabric.loops.size(); ++i) {
        for (const LoopIndex parent : fabric.made.parentsOf(static_cast<LoopIndex>(i))) {
            ++first[static_cast<std::size_t>(parent) + 1];
        }
    }
    std::partial_sum(first.begin(), first.end(), first.begin());
    fabric.through.resize(static_cast<std::size_t>(first.back()));
    std::vector<std::int32_t> next(first.begin(), first.end() - 1);
    for (std::size_t i = 0; i < fabric.loops.size(); ++i) {
        for (const LoopIndex parent : fabric.made.parentsOf(static_cast<LoopIndex>(i))) {
            const auto slot = static_cast<std::size_t>(next[static_cast<std::size_t>(parent)]++);
            fabric.through[slot] = static_cast<LoopIndex>(i);
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
    tracker.finish();

    Fabric fabric;
    fabric.pitchMm = timeline.profile().pitchMm();
    fabric.made = emulator.takeLoops();
    const CourseNumbers courses = numberCourses(timeline);
    fabric.loops = fatesToLoops(fabric.made, tracker, courses);
    placeInStacks(fabric.made, emulator.state(), fabric.loops);
    listDrawnThrough(fabric);
    for (const Loop& loop : fabric.loops) {
        fabric.courseCount = std::max(fabric.courseCount, loop.course + 1);
    }

    EntryTable entries(fabric.loops.size());
    joinHeads(fabric.made, emulator.state(), entries);
    const LegCrossings crossings(tracker, fabric.loops.size());
    threadYarns(fabric, courses, crossings, entries);
    layOutOnMachine(fabric, timeline.profile());
    indexEntries(fabric);
    return fabric;
}

} // namespace knittsim::fabric
