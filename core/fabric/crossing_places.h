#pragma once

#include "core/fabric/wale_places.h"

namespace knittsim::fabric {

/// Fills Fabric::machinePositions of all crossings, where those of heads are known: a float crosses legs at
/// the height of the course in which it was laid, and where the legs stand; legs cross each other between
/// their feet and their heads in the order of time. `height` of a course, mm; `wales` by loop, where the yarn
/// was laid.
void placeCrossings(Fabric& fabric, double height, const std::vector<WalePlace>& wales);

} // namespace knittsim::fabric
