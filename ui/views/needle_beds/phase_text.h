#pragma once

#include "core/machine/operation.h"

#include <QString>

namespace knittsim::ui {

/// What happens at this moment of an operation, in a few words: "The needle rises". Empty at rest and where
/// nothing of it is seen. `holdsLoop`: the needle held a loop before the operation.
QString phaseText(const machine::Operation& operation, double phase, bool holdsLoop);

} // namespace knittsim::ui
