#pragma once

#include "core/geometry/yarn_curve.h"

#include <vector>

namespace knittsim::simulation {

/// A shape of yarns to look at. Forces are empty while the yarns grow, for then they know none.
struct YarnPicture {
    geometry::YarnCurves curves;
    std::vector<float> positions; ///< 3 per entry of the bonding point table, mm
    std::vector<float> tension;   ///< by node: mean of the segments at it, mN; negative: pressed together
    std::vector<float> contact;   ///< by node: with which other yarn pushes it, mN by mm of yarn
};

} // namespace knittsim::simulation
