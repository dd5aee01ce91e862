#include "core/pattern/move_plan.h"

#include <algorithm>

namespace knittsim::pattern {

namespace {

bool meet(const LoopMove& a, const LoopMove& b) {
    return a.to == b.to || ((a.from < b.from) != (a.to < b.to));
}

} // namespace

std::vector<MoveStep> planMoves(const std::vector<LoopMove>& moves) {
    std::vector<MoveStep> steps;
    for (const LoopMove& move : moves) {
        const auto meets = [&](const MoveStep& step) {
            return std::ranges::any_of(step.moves, [&](const LoopMove& other) { return meet(move, other); });
        };
        // Not before the last step with a loop that this one must follow.
        const auto lastMet = std::find_if(steps.rbegin(), steps.rend(), meets).base();
        const int rack = move.to - move.from;
        const auto step =
            std::find_if(lastMet, steps.end(), [&](const MoveStep& s) { return s.rack == rack; });
        if (step != steps.end()) {
            step->moves.push_back(move);
        } else {
            steps.push_back({rack, {move}});
        }
    }
    return steps;
}

} // namespace knittsim::pattern
