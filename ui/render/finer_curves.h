#pragma once

#include "core/geometry/yarn_curve.h"

#include <span>
#include <vector>

namespace knittsim::render {

/// `times` pieces for each piece of the curves, on Catmull-Rom splines through the nodes: where a stitch
/// fills the screen, one sees no corners. What else is known of a node goes over in straight lines.
geometry::YarnCurves finer(const geometry::YarnCurves& curves, int times);

/// Values by node of `curves` for the nodes of finer().
std::vector<float> finer(const geometry::YarnCurves& curves, std::span<const float> values, int times);

} // namespace knittsim::render
