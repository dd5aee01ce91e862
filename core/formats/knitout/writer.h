#pragma once

#include "core/machine/program.h"

#include <string>

namespace knittsim::formats::knitout {

/// The program as knitout 2 text. parse(write(p)) gives p again, but for `file` and line numbers.
std::string write(const machine::Program& program);

} // namespace knittsim::formats::knitout
