#pragma once

#include "core/fabric/fabric.h"

#include <vector>

namespace knittsim::fabric {

/// True when the loops marked in `front` (by loop) can be pulled away from all others towards a viewer of the
/// front bed: no loop of one layer is drawn through one of the other, none shares a needle with one, and
/// wherever strands of the two layers cross, that of the front layer lies in front. Yarn that runs from one
/// layer to the other joins them at that place and does not keep them together elsewhere.
bool canBePulledApart(const Fabric& fabric, const std::vector<bool>& front);

/// Crossings between strands of the two layers.
int crossingsBetween(const Fabric& fabric, const std::vector<bool>& front);

} // namespace knittsim::fabric
