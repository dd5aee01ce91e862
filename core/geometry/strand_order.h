#pragma once

#include "core/fabric/fabric.h"

#include <span>
#include <vector>

namespace knittsim::geometry {

/// Where a strand lies in depth at the two real crossings that a bonding point merges: the lower one, where
/// the foot of the new loop meets the leg of the old one, and the upper one, where the leg of the new loop
/// meets the head of the old one. mm along the fabric's normal, + towards a viewer of the front bed.
struct StrandDepth {
    float lower = 0;
    float upper = 0;
};

/// +1 for a loop pulled from back to front (made on the front bed), -1 for its mirror image.
int pullSign(const fabric::Fabric& fabric, machine::LoopIndex loop);

/// By bonding point. A new loop lies behind its parents at the lower crossing and in front of them at the
/// upper one (front bed; mirrored on the rear bed). Parents lie in the order of the needle's stack, the first
/// one nearest to the side the loop is pulled to. Neighbours in depth are half the sum of their diameters
/// apart, less in stacks. `diameterMm` by carrier.
std::vector<StrandDepth> orderStrands(const fabric::Fabric& fabric, std::span<const double> diameterMm);

} // namespace knittsim::geometry
