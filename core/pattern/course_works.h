#pragma once

#include "core/machine/operation.h"
#include "core/pattern/chart.h"
#include "core/pattern/held_loops.h"

#include <optional>
#include <vector>

/// What the carriers do in one course. Needles are numbered as wales: needle 0 belongs to wale 0.
namespace knittsim::pattern {

/// One thing a carrier does on its way.
struct Work {
    machine::OperationKind kind = machine::OperationKind::Knit; ///< Knit, Tuck or Miss
    machine::Needle needle;
};

/// Yarns with work in this course, in rising order.
std::vector<int> yarnsOf(const Chart& chart, int course);

/// Racking in pitches: a quarter more where both needles of a wale work, so that they do not meet.
double rackOf(const Chart& chart, int course);
bool worksBothBeds(const Chart& chart, int course);

/// What a needle of this bed does; nothing: it has no part in the cell. Tucks and misses without a bed are on
/// `loopBed`.
std::optional<machine::OperationKind> workOn(machine::Bed bed, Stitch stitch, machine::Bed loopBed);

/// Bed of tucks and misses that name none.
machine::Bed loopBedOf(const Chart& chart, const HeldLoops& held, int wale);

/// What one cell asks for, without the back of its course.
std::vector<Work> worksOf(const Cell& cell, int wale, machine::Bed loopBed);

/// Work of one yarn from left to right, that on the back of the course included.
std::vector<Work> worksOf(const Chart& chart, int course, int yarn, const HeldLoops& held);

/// Adds the tuck with which an intarsia yarn that goes to `direction` joins the next zone. Nothing at the
/// edge of the fabric, or where no loop holds the tuck.
void addJoin(std::vector<Work>& works, const Chart& chart, int course, machine::Direction direction,
             const HeldLoops& held);

/// Leftmost wale that `yarn` works in this course; there must be one.
int firstWaleOf(const Chart& chart, int course, int yarn);

} // namespace knittsim::pattern
