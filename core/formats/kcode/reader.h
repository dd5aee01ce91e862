#pragma once

#include "core/base/result.h"
#include "core/machine/program.h"

#include <string>
#include <string_view>

namespace knittsim::formats::kcode {

/// Reads k-code: passes of FRNT, STIF, REAR, STIR and an action line, with HOME, RACK and comments between
/// them. Any bytes are safe; time is linear in their number.
///
/// Needle 1 is the first needle behind the margin. A carrier comes in at its first pass and goes out at a
/// pass whose comment says so, else at the end. Stroke without yarn: knit drops, tuck is an a-miss. Carrier
/// stops and empty strokes leave every loop where it is and are no part of the program; so a `miss` is not
/// found again. Stitch sizes become x-stitch-number, speed and take-down of working passes x-speed-number and
/// x-roller-advance. Lines between the passes that are none of these become `pause` with their text.
///
/// Errors and warnings: KS0112, KS0113, KS0115, KS0116, KS0121, KS0122, KS0125, KS0126, KS0140 to KS0146.
Result<machine::Program> parse(std::string_view text, const std::string& file);

} // namespace knittsim::formats::kcode
