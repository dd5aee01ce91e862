#pragma once

#include "core/fabric/fabric.h"

#include <vector>

namespace knittsim::fabric {

/// Where the heads of a loop stand along the bed, needle pitches.
struct WalePlace {
    double centre = 0;
    double halfWidth = 0.25;
};

/// By loop. The heads of a loop stand at the needle on which the next loop came through them. Needles of both
/// beds that knit one after the other in one pass stand half a pitch apart, in the order of the pass, even
/// where the program leaves them face to face, as the wales of a full rib lie beside each other.
std::vector<WalePlace> walePlaces(const Fabric& fabric);

} // namespace knittsim::fabric
