#pragma once

#include "core/geometry/yarn_curve.h"

#include <vector>

namespace knittsim::geometry {

/// Where two strands cross in the projection along z, seen from the front.
struct ProjectedCrossing {
    std::int32_t over = 0;  ///< node before the crossing on the strand nearer to the viewer
    std::int32_t under = 0; ///< likewise on the other
    float overShare = 0;    ///< place between the node and the next, 0 to 1
    float underShare = 0;
    float gapMm = 0; ///< between the centrelines, along z
    int sign = 0;    ///< of the cross product of the directions over x under, both along their yarns
};

/// All crossings of the curves, ordered by node. The view is tilted by a thousandth so that strands that lie
/// exactly behind each other have an order. Throws nothing; nodes that are not finite cross nothing.
std::vector<ProjectedCrossing> projectCrossings(const YarnCurves& curves);

} // namespace knittsim::geometry
