#pragma once

#include "core/machine/operation.h"
#include "core/pattern/chart.h"
#include "core/pattern/held_loops.h"

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

/// Racking in pitches: a quarter more where both needles of a wale knit, so that they do not meet.
double rackOf(const Chart& chart, int course);
bool worksBothBeds(const Chart& chart, int course);

/// What one cell asks for; tucks and misses on `loopBed`.
std::vector<Work> worksOf(const Cell& cell, int wale, machine::Bed loopBed);

/// Work of one yarn from left to right.
std::vector<Work> worksOf(const Chart& chart, int course, int yarn, const HeldLoops& held);

/// Adds the tuck with which an intarsia yarn that goes to `direction` joins the next zone. Nothing at the
/// edge of the fabric, or where no loop holds the tuck.
void addJoin(std::vector<Work>& works, const Chart& chart, int course, machine::Direction direction,
             const HeldLoops& held);

/// Leftmost wale that `yarn` works in this course; there must be one.
int firstWaleOf(const Chart& chart, int course, int yarn);

} // namespace knittsim::pattern
