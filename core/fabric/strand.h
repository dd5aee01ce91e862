#pragma once

#include "core/fabric/fabric.h"

#include <compare>
#include <cstdint>

namespace knittsim::fabric {

/// A strand that can pass others on the machine: the two legs of a held loop together, or the yarn between a
/// carrier's last loop and its next one (a float, open until that loop is made).
struct Strand {
    enum class Kind : std::uint8_t { Loop, Float } kind = Kind::Loop;
    std::int32_t index = 0; ///< LoopIndex, or number of the float

    auto operator<=>(const Strand&) const = default;
};

/// Two strands passed each other. `over` lies nearer to the front bed.
struct Passing {
    Strand over;
    Strand under;
    OperationIndex operation = 0;
    std::int8_t sign = 1; ///< +1: over went from left to right of under
    bool undone = false;
    float place = 0; ///< along the bed, pitches; beside the needle where a yarn waits
    /// Passings at one place of the bed at one moment have the same number. Strands that stand at one place
    /// (a stack, yarns of one operation, loops that face each other) have no order across.
    std::int32_t moment = 0;

    Strand other(Strand strand) const { return strand == over ? under : over; }
    /// +1 when `strand`, one of the two, went to the right past the other one.
    int directionOf(Strand strand) const { return strand == over ? sign : -sign; }
};

} // namespace knittsim::fabric
