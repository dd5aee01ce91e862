#pragma once

#include "core/fabric/fabric.h"
#include "core/geometry/yarn_curve.h"

#include <span>
#include <vector>

namespace knittsim::render {

/// By bonding point: way from one shape to another, mm. Shapes have 3 numbers an entry, mm; nothing where
/// they do not fit the fabric.
std::vector<float> movementOfPoints(const fabric::Fabric& fabric, std::span<const float> now,
                                    std::span<const float> before);

/// By node likewise; nothing where the curves have other nodes.
std::vector<float> movementOfNodes(const geometry::YarnCurves& now, const geometry::YarnCurves& before);

} // namespace knittsim::render
