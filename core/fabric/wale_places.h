#pragma once

#include "core/fabric/fabric.h"

#include <vector>

namespace knittsim::fabric {

/// A place along the bed, needle pitches.
struct WalePlace {
    double centre = 0;
    double halfWidth = 0.25;
};

/// By loop. Loops of both beds that stand a fraction of a pitch apart are narrow and half a pitch apart, so
/// that the wales of a full rib lie beside each other; where needles that face each other knit one after the
/// other in one pass, their loops are drawn half a pitch apart in the order of the pass.
struct WalePlaces {
    std::vector<WalePlace> made;  ///< where the yarn was laid
    std::vector<WalePlace> bound; ///< where the next loop came through, or where the loop hangs at the end
};

WalePlaces walePlaces(const Fabric& fabric);

} // namespace knittsim::fabric
