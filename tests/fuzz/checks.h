#pragma once

#include "core/base/result.h"
#include "core/machine/program.h"

#include <string>

namespace knittsim::test {

/// Ends the program with a message when the condition does not hold.
void require(bool condition, const std::string& what);

/// What a reader says is in the message table, has a place, is short and little; there is a program exactly
/// when there is no error.
void checkReading(const Result<machine::Program>& result);

/// What the writers make of a program opens again and means the same.
void checkWriters(const machine::Program& program);

/// The program runs on the machine and becomes a fabric, as a whole and in half.
void checkMachineAndFabric(machine::Program program);

} // namespace knittsim::test
