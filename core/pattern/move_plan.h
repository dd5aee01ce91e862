#pragma once

#include "core/pattern/chart.h"

#include <vector>

namespace knittsim::pattern {

/// Loops that go from the rear to the front bed at one racking.
struct MoveStep {
    int rack = 0; ///< pitches = to - from of each of its moves
    std::vector<LoopMove> moves;

    bool operator==(const MoveStep&) const = default;
};

/// Rackings that carry out `moves` with all loops waiting on the rear bed. Two moves that cross or end on one
/// wale keep their order, so the loop listed first reaches the front bed first and lies in front; others
/// share rackings.
std::vector<MoveStep> planMoves(const std::vector<LoopMove>& moves);

} // namespace knittsim::pattern
