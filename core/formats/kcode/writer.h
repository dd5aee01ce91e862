#pragma once

#include "core/base/result.h"
#include "core/machine/program.h"

#include <string>
#include <string_view>

namespace knittsim::formats::kcode {

/// The program as k-code, as the open knitout tool writes it; `name` is the file name that the text carries.
/// Carriers have to be named 1 to 6; ';;Position:' (Center unless named) places the piece on 252 needles.
/// Besides the extensions of passes::planPasses it takes x-carrier-spacing and x-carrier-stopping-distance,
/// whose last values hold for the whole program.
///
/// Errors: those of passes::planPasses; KS0149 for what the machine cannot do.
Result<std::string> write(const machine::Program& program, std::string_view name);

} // namespace knittsim::formats::kcode
