#pragma once

#include "core/machine/program.h"

namespace knittsim::ui {

/// How much faster than `speed` (operations a second) an operation is played to a class: 1 where the same
/// operation on the same bed was hardly seen before it, more the more often it came of late, up to
/// kSkimmingSpeed. What is faster already stays as it is.
double skimmingHaste(const machine::Program& program, int operation, double speed);

constexpr double kSkimmingSpeed = 10; ///< operations a second that are still seen

} // namespace knittsim::ui
