#pragma once

#include "core/machine/checks/check.h"

#include <nlohmann/json_fwd.hpp>

namespace knittsim::machine {

/// Array of what was found, then of what is turned off: "rule", "name", "severity", "line", "column",
/// "operation", "needle" (null where not known), "cause", "cure" and, where the rule is off, "off_reason".
nlohmann::ordered_json findingsJson(const CheckResult& result);

} // namespace knittsim::machine
