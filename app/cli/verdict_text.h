#pragma once

#include "core/physics/stop_rule.h"

namespace knittsim::cli {

/// Why a run of the yarn model ended, for people.
const char* verdictText(physics::StopRule::Verdict verdict);

} // namespace knittsim::cli
