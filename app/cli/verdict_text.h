#pragma once

#include "core/physics/stop_rule.h"

namespace knittsim::cli {

/// Why a run of the yarn model ended, for people.
const char* verdictText(physics::StopRule::Verdict verdict);

/// Whether that means rest.
inline bool isAtRest(physics::StopRule::Verdict verdict) {
    return verdict == physics::StopRule::Verdict::ResidualReached ||
           verdict == physics::StopRule::Verdict::Stagnation;
}

} // namespace knittsim::cli
