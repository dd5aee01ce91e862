#pragma once

#include "core/fabric/fabric.h"

namespace knittsim::fabric {

/// Fills Fabric::firstOfEntry and ::pointsOfEntry from ::points and ::entryCount.
void indexEntries(Fabric& fabric);

} // namespace knittsim::fabric
