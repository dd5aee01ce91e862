#pragma once

#include "core/machine/program.h"

#include <string>

namespace knittsim::formats::knitout {

/// The program as knitout 2 text. parse(write(p)) gives p again, but for `file` and line numbers, when the
/// carriers stand in the order of the rails with those parked left first (else they are put into that order),
/// and when knit, tuck and split have carriers. Line ends in texts become blanks, so that no text can add an
/// operation.
std::string write(const machine::Program& program);

} // namespace knittsim::formats::knitout
