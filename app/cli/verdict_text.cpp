#include "app/cli/verdict_text.h"

namespace knittsim::cli {

const char* verdictText(physics::StopRule::Verdict verdict) {
    using enum physics::StopRule::Verdict;
    switch (verdict) {
    case ResidualReached:
        return "residual reached";
    case Stagnation:
        return "shape and energy no longer change";
    case StepLimit:
        return "step limit";
    case Diverged:
        return "diverged";
    case SolverFailed:
        return "solver failed";
    case GoOn:
        break;
    }
    return "time limit";
}

} // namespace knittsim::cli
