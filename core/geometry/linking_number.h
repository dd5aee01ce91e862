#pragma once

#include "core/base/vec3.h"

#include <span>

namespace knittsim::geometry {

/// How often two closed polylines wind around each other: half the sum of the signs of the crossings that any
/// viewer sees (+1 when the front one turns to the left onto the rear one). The last point of each is joined
/// to the first. They must not touch; then the result is a whole number up to rounding (about 1e-10).
///
/// Gauss integral, exact for straight pieces: every pair of segments adds the solid angle that the directions
/// from one to the other cover, over 4 pi. Each solid angle is that of two spherical triangles (van Oosterom
/// and Strackee 1983). Qu and James, "Fast Linking Numbers for Topology Verification of Loopy Structures"
/// (2021). Time is the product of the two point counts.
double linkingNumber(std::span<const Vec3> a, std::span<const Vec3> b);

} // namespace knittsim::geometry
