#pragma once

#include "core/machine/program.h"

#include <functional>
#include <string>

namespace knittsim::test {

/// What is wrong with a program, or nothing.
using Property = std::function<std::string(const machine::Program&)>;

/// True when the machine can carry out the whole program.
bool isValid(const machine::Program& program);

/// A valid program for which `fails` still holds and from which no single pass, run of 2, 4, ... operations
/// or operation can be taken out. `fails` must hold for `program` itself.
machine::Program shrink(machine::Program program, const std::function<bool(const machine::Program&)>& fails);

/// The smallest failing program made from `program`, as knitout, with what is wrong with it; nothing when the
/// property holds.
std::string explainFailure(const machine::Program& program, const Property& property);

} // namespace knittsim::test
