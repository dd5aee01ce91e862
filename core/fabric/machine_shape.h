#pragma once

#include "core/fabric/fabric.h"
#include "core/machine/profile.h"

namespace knittsim::fabric {

/// Fills Fabric::machinePositions: where the bonding points are while the fabric hangs on the machine.
/// Across, the needle where the loop was bound; in depth, half the bed gap to the front or the rear; in
/// height, courses as tall as a loop stretched over a needle is. Crossings lie between their neighbours on
/// both strands.
void layOutOnMachine(Fabric& fabric, const machine::MachineProfile& profile);

/// Fabric::machinePositions as shapes are handed on: 3 numbers an entry, mm.
std::vector<float> machinePlaces(const Fabric& fabric);

/// Yarn of a loop and its sinker, mm, as fed; 0 without loops.
double meanLoopLength(const Fabric& fabric);

} // namespace knittsim::fabric
