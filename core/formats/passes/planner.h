#pragma once

#include "core/base/result.h"
#include "core/formats/passes/pass.h"
#include "core/formats/passes/pass_rules.h"
#include "core/machine/program.h"

#include <vector>

namespace knittsim::formats::passes {

/// The carriage passes that carry out a program, in order, with the passes that a machine needs besides: soft
/// misses that carry a yarn out of the way of a needle or to the side from which it has to start.
///
/// Takes the extensions x-speed-number, x-presser-mode, x-end-pass, x-xfer-style, x-xfer-stitch-number,
/// x-roller-advance and x-add-roller-advance; other extensions and colours have no effect. Time is
/// proportional to operations x carriers.
///
/// Errors: those of the emulator (KS02xx) for what no machine can do, KS0210 for a carrier never taken out,
/// and `rules.refusal` for what these machines cannot do. The first one only.
Result<std::vector<Pass>> planPasses(const machine::Program& program, const PassRules& rules);

} // namespace knittsim::formats::passes
