#pragma once

#include "core/machine/operation.h"

#include <cstdint>
#include <span>
#include <vector>

namespace knittsim::machine {

using LoopIndex = std::int32_t;

/// Yarn hung on a needle by one operation.
struct Loop {
    OperationIndex operation = 0; ///< that made it
    CarrierIndex carrier = 0;
    OperationKind kind = OperationKind::Knit; ///< Knit, Tuck or Split
    Direction direction = Direction::Right;   ///< in which the yarn ran through it
    Needle needle;                            ///< on which it was made
    double rack = 0;                          ///< racking then, pitches
    double lengthMm = 0;                      ///< yarn of the loop from the stitch size
    double wayPitches = 0;  ///< way of the yarn from the loop before it; 0 for the first of a yarn
    double floatMm = 0;     ///< yarn of that way beyond the sinker that `lengthMm` includes
    double yarnBeginMm = 0; ///< arc length along its yarn where the loop with its sinker begins
    double yarnEndMm = 0;
    std::int32_t firstParent = 0; ///< into LoopTable::parents
    std::int32_t parentCount = 0; ///< loops it was pulled through, in the order of the needle's stack
    std::int32_t yarn = 0;        ///< running number of the yarn: a carrier from its `in` to its `out`
};

/// All loops a program makes, in the order they are made. After operation k exactly the first
/// `MachineState::loopCount` of them exist.
struct LoopTable {
    std::vector<Loop> loops;
    std::vector<LoopIndex> parents;

    std::span<const LoopIndex> parentsOf(LoopIndex loop) const {
        const Loop& l = loops[static_cast<std::size_t>(loop)];
        return {parents.data() + l.firstParent, static_cast<std::size_t>(l.parentCount)};
    }
};

} // namespace knittsim::machine
