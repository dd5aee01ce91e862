#pragma once

#include "core/machine/program.h"

#include <string>

namespace knittsim::test {

/// What is different in two programs, in words, or an empty text. Files, line numbers and the order of
/// Program::texts do not count; what each operation says does.
std::string difference(const machine::Program& a, const machine::Program& b);

} // namespace knittsim::test
