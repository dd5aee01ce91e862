#pragma once

#include "core/simulation/fabric_yarns.h"

namespace knittsim::simulation {

/// Factors along x and y from the machine's shape to the spacings that the layout asks for: those it gives,
/// else those of the fabric's repeat, else those of the bonding-point model at rest.
Eigen::Vector2d drawIn(const fabric::Fabric& f, std::span<const yarn::Yarn> yarns, const YarnLayout& layout);

} // namespace knittsim::simulation
