#pragma once

#include "core/pattern/chart.h"
#include "core/pattern/lift_input.h"

#include <vector>

namespace knittsim::pattern {

/// How passes are gathered into courses; no way is right for all programs.
struct CourseRules {
    bool castOn = false;    ///< tucks on empty needles at the beginning belong to the first course
    bool missesWork = true; ///< a wale that a carrier misses is one that it works
    /// Yarns come in any order, and a tuck at the end of a pass may join the zone beside it; else they come
    /// in their order.
    bool zones = true;
    bool backing = false;    ///< two carriers may work the two needles of one wale
    bool doubleBeds = false; ///< a wale has its own needle on each bed
};

/// One course of a program and what it makes.
struct ProgramSegment {
    std::size_t first = 0; ///< operation
    std::size_t end = 0;
    std::vector<Cell> cells; ///< by wale
    /// Of the loops that were there before; where there are several, in the orders that the transfers may
    /// come from, the likeliest first.
    std::vector<std::vector<LoopMove>> moves;
    double rack = 0; ///< while its carriers work, pitches
    std::optional<double> stitchNumber;
    bool joins = false; ///< some carrier may tuck on the zone beside its own
};

/// Operations after the last of them belong to no course.
std::vector<ProgramSegment> coursesOf(const LiftInput& input, const CourseRules& rules);

} // namespace knittsim::pattern
