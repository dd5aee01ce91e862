#pragma once

#include "core/base/result.h"
#include "core/machine/program.h"

#include <string>
#include <string_view>

namespace knittsim::formats::shima_dat {

/// Reads a DAT picture laid out as the open knitout tools do (layout.h). Any bytes are safe; time and memory
/// are linear in their number and in the picture, which is checked against them first.
///
/// Needles have the numbers that the position line gives the piece, from 1 on where there is none. The fixed
/// passes before and after the program, which empty the needles, are no part of it; neither are carriage
/// moves and soft misses, which leave every loop and float where it is. Stitch numbers become
/// x-stitch-number; speed and presser are kept as x-speed-number and x-presser-mode. Operation::line is the
/// row of the picture, 1 at the bottom.
///
/// Errors and warnings: KS0125, KS0130 to KS0138 with the row as line and the column as column.
Result<machine::Program> parse(std::string_view bytes, const std::string& file);

} // namespace knittsim::formats::shima_dat
