#pragma once

#include "core/geometry/yarn_curve.h"

namespace knittsim::geometry {

/// Where two strands come nearest to each other.
struct StrandDistance {
    double mm = 0;           ///< between centrelines; `limitMm` when none are nearer
    std::int32_t nodeA = -1; ///< nodes before the nearest places, -1 for none
    std::int32_t nodeB = -1;
};

/// The smallest distance between strands that are not neighbours along one yarn: places of one yarn count
/// when more than `apartMm` of yarn lies between them. Looks no farther than `limitMm`.
StrandDistance smallestDistance(const YarnCurves& curves, double limitMm, double apartMm);

} // namespace knittsim::geometry
