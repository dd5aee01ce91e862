#pragma once

#include "core/fabric/fabric.h"
#include "core/geometry/yarn_curve.h"

#include <vector>

namespace knittsim::geometry {

/// A loop that the curves do not draw through the loop that it was knitted through.
struct PullThrough {
    machine::LoopIndex loop = -1;
    machine::LoopIndex parent = -1;
    int in = 0;  ///< signed piercings of the parent by the first half of the loop along its yarn
    int out = 0; ///< likewise by the second half
};

struct TopologyCertificate {
    std::size_t pairs = 0; ///< loops and the loops they were drawn through
    std::vector<PullThrough> failures;

    bool holds() const { return failures.empty(); }
};

/// For every loop and every loop that it is drawn through: the older one is closed with the chord between the
/// ends of its legs and spanned by a fan of triangles; the first half of the new loop must pierce it once
/// towards the side that it is pulled to, the second half once back. Holds for any shape, flat or curled, in
/// which loops are not folded over themselves. Stitches of all kinds count: a tuck or a held loop is pierced
/// by the loop that comes through its whole stack.
TopologyCertificate certifyTopology(const fabric::Fabric& fabric, const YarnCurves& curves);

} // namespace knittsim::geometry
