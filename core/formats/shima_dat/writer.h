#pragma once

#include "core/base/result.h"
#include "core/machine/program.h"

#include <string>

namespace knittsim::formats::shima_dat {

/// The program as a DAT picture, byte for byte as the open knitout tools write it. Carriers have to be named
/// 1 to 10; ';;Position:' (Center unless named) and ';;Width:' (540 unless named) place the piece.
///
/// Errors: those of passes::planPasses; KS0139 for what the format cannot say.
Result<std::string> write(const machine::Program& program);

} // namespace knittsim::formats::shima_dat
