#pragma once

#include "core/machine/program.h"

#include <string>

namespace knittsim::test {

/// Runs both programs on the same machine and tells in words the first thing that differs, or nothing: every
/// loop in its order (knit, tuck or split, direction, bed, needle, carrier name, the loops it was pulled
/// through, which loops share a yarn) and where the loops hang at the end. `shift` is added to the needle
/// numbers of `a`.
std::string differenceInMeaning(const machine::Program& a, const machine::Program& b, int shift = 0);

} // namespace knittsim::test
