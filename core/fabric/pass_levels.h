#pragma once

#include "core/fabric/fabric.h"

#include <vector>

namespace knittsim::fabric {

/// By loop: how high in its course the yarn lay down, in courses from 0 to below 1/2. The passes of one
/// course are stacked in the order of time, so that yarn that came later lies above yarn that was there.
std::vector<float> passLevels(const Fabric& fabric);

} // namespace knittsim::fabric
