#pragma once

#include "core/machine/profile.h"
#include "core/machine/program.h"

namespace knittsim::machine {

/// The machine a program is emulated on: the generic one, with the gauge that ';;Gauge:' names; a coarser or
/// finer gauge takes loops longer or shorter in proportion.
MachineProfile chooseProfile(const Header& header);

} // namespace knittsim::machine
