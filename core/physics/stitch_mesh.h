#pragma once

#include "core/physics/curl_term.h"
#include "core/physics/model_options.h"
#include "core/physics/shear_term.h"
#include "core/physics/straight_term.h"
#include "core/physics/strand.h"
#include "core/yarn/yarn.h"

#include <span>
#include <vector>

namespace knittsim::physics {

/// Turn of the course at the sides of a stitch whose neighbour shows the other face, radians. The side
/// towards that neighbour turns freely (an odd connector is 15 times softer than an even one,
/// PHYSICS-REFERENCE 3.5); the other side half as far. Two numbers for every pattern, from the ordering of
/// rods and swatches: 1x1 rib comes to (1 + cos 70)/2 = 0.67 of plain (rods 0.51 to 0.64, swatches 0.72), 2x2
/// rib to 0.60 (rods 0.48, swatches 0.62).
constexpr double kCurlTowardsOther = 1.22; // 70 degrees
constexpr double kCurlTowardsSame = 0.61;

/// What holds the net of stitches in shape besides the springs.
struct StitchMesh {
    std::vector<Straight>
        straights;           ///< wales and courses run on through a bonding point; strands through crossings
    std::vector<Curl> curls; ///< courses that turn out of the plane
    std::vector<Corner> corners; ///< legs stand across heads and sinkers
};

/// Where a loop comes through another one four strands meet: the heads and the leg of the old loop, the
/// sinker and the leg of the new one. Leg runs on into leg and heads into sinker. A stitch drawn to the front
/// curls with its sides to the back and one drawn to the rear the other way (PHYSICS-REFERENCE 3.3). That is
/// what pulls a rib in. In the middle of a plain panel the fabric is taken to lie flat, and where the face
/// changes with every course (seed) the curls cancel; so only stitches beside a change of face, in a wale
/// that keeps its face, curl.
StitchMesh findStitchMesh(const fabric::Fabric& fabric, const Strands& strands,
                          std::span<const yarn::Yarn> yarns, const PreviewOptions& options);

} // namespace knittsim::physics
