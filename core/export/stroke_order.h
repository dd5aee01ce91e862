#pragma once

#include "core/geometry/yarn_curve.h"

#include <vector>

namespace knittsim::exports {

/// A piece of a yarn that lies in front at all of its crossings or behind at all of them.
struct Stroke {
    std::size_t yarn = 0; ///< index into YarnCurves::yarns
    float from = 0;       ///< arc length along the yarn, mm
    float to = 0;
};

/// Cuts all yarns into strokes, in the order in which they have to be painted to be seen from the front, or
/// from the back: at every crossing of the projection along z the strand nearer to the viewer comes later.
/// Always possible: of two strokes that cross, one is in front wherever it crosses and the other one never,
/// so no ring of strokes lies one over the other. Where strokes do not cross but lie side by side, the one
/// that is farther away on average comes first; so that this is true all along, none is longer than
/// `mostMm`.
std::vector<Stroke> strokesInOrder(const geometry::YarnCurves& curves, float mostMm, bool back);

} // namespace knittsim::exports
