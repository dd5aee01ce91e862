#pragma once

#include "core/physics/yarn_model/chains.h"

#include <optional>
#include <vector>

namespace knittsim::physics {

/// Point `a` and an image of point `b`.
struct NearPair {
    Entry a = 0;
    Place b;
};

/// Every pair of points nearer than `range`, once each; with `cell` also pairs of a point and images, its own
/// included. By a grid: time and memory linear in the points for a bounded density.
std::vector<NearPair> findNearPairs(const Eigen::Matrix3Xd& points,
                                    const std::optional<Eigen::Vector2d>& cell, double range);

/// Those of them, without a cell, that a chosen point is part of; `chosen` by point. a < b.
std::vector<NearPair> findNearPairsOf(const Eigen::Matrix3Xd& points, const std::vector<char>& chosen,
                                      double range);

} // namespace knittsim::physics
