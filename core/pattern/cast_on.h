#pragma once

#include "core/pattern/feeds.h"
#include "core/pattern/held_loops.h"

namespace knittsim::pattern {

/// Tucks on every second needle to the left and on the others back, with the yarn at the right end of course
/// 0, each on the bed where its wale begins. A tube is cast on round: front and rear bed in turn, four
/// passes.
void castOnAlternating(const Chart& chart, Feeds& feeds, HeldLoops& held, ProgramBuilder& builder);

} // namespace knittsim::pattern
