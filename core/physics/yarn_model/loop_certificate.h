#pragma once

#include "core/physics/yarn_model/knit_cell.h"

#include <vector>

namespace knittsim::physics {

/// A stitch of a cell that is not drawn through the one below it as its face says.
struct LoopFault {
    int wale = 0;
    int course = 0;
    int leftPiercings = 0;  ///< signed, by the left half of the loop; right is +face
    int rightPiercings = 0; ///< right is -face
};

/// The topology certificate of PHYSICS-REFERENCE 6.6: the loop below is closed with the chord of its base and
/// filled with a fan of triangles; the left half of the loop above must pierce it once to its side, the right
/// half once back. `perLoop` nodes a loop from sinker to sinker, as knitCell lays them. Empty: all is well.
std::vector<LoopFault> findLoopFaults(const KnitPurl& pattern, const YarnChains& chains, const Vector& x,
                                      int perLoop);

} // namespace knittsim::physics
