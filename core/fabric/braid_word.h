#pragma once

#include "core/fabric/fabric.h"

#include <optional>
#include <span>
#include <vector>

namespace knittsim::fabric {

/// The braid word of strands that cross each other, each one loop or several loops side by side, given from
/// left to right as they start. Upwards (in time), +i means that strand i (counted from 1, as they lie then)
/// goes to the right in front of strand i + 1, -i that it goes to the right behind it. Nothing when the
/// crossings are not those of a braid of these strands: when two loops of one strand cross others differently
/// or something else runs between.
std::optional<std::vector<int>> braidWord(const Fabric& fabric,
                                          std::span<const std::vector<LoopIndex>> strands);

} // namespace knittsim::fabric
