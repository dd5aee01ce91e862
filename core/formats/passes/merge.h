#pragma once

#include "core/formats/passes/pass.h"
#include "core/formats/passes/pass_rules.h"

namespace knittsim::formats::passes {

/// Makes `next` part of `pass` where one carriage stroke can do both in their order: same kind, racking,
/// speed, direction and carriers, slots that go on in the direction, hook and gripper only at the ends, and
/// the machine's own rules. Returns false, and changes nothing, when it cannot.
bool append(Pass& pass, const Pass& next, const PassRules& rules);

} // namespace knittsim::formats::passes
