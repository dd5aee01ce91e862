#pragma once

#include "core/fabric/course_heights.h"
#include "core/fabric/wale_places.h"

namespace knittsim::fabric {

/// Fills Fabric::machinePositions of all crossings, where those of heads are known: a float crosses legs at
/// the height of the course in which it was laid, and where the legs stand; legs cross each other between
/// their feet and their heads in the order of time. `wales` by loop, where the yarn
/// was laid.
void placeCrossings(Fabric& fabric, const CourseHeights& heights, const std::vector<WalePlace>& wales);

} // namespace knittsim::fabric
