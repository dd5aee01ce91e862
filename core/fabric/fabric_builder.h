#pragma once

#include "core/fabric/fabric.h"
#include "core/machine/timeline.h"

#include <memory>

namespace knittsim::fabric {

/// Builds the fabric that the machine has made after the first `count` operations (all when negative).
/// Linear in the number of loops and crossings.
Fabric buildFabric(const machine::Timeline& timeline, OperationIndex count = -1);

} // namespace knittsim::fabric
