#pragma once

#include "core/physics/yarn_model/chains.h"
#include "core/yarn/yarn.h"

namespace knittsim::physics {

/// The units of the yarn model: those of one yarn.
struct YarnUnits {
    double lengthMm = 1;         ///< its outer diameter d
    double bendingStiffness = 1; ///< its EI, mN mm^2

    double forceMilliNewton() const { return bendingStiffness / (lengthMm * lengthMm); }
    double energyMicroJoule() const { return bendingStiffness / lengthMm; }
};

YarnUnits unitsOf(const yarn::Yarn& yarn);

/// A library yarn for the model. Its contact stiffness follows by similarity from the measured acrylic of
/// PHYSICS-REFERENCE 2.4: kContactStiffness in its own units for every yarn. A core as thick as the yarn
/// (monofilaments) is taken as 95 % of it, so that there is a shell at all.
RodYarn toRod(const yarn::Yarn& yarn, const YarnUnits& units);

/// k d^5 / EI; the published 1e-4 to 1e-3 N/mm^3 of an acrylic with 0.09 N mm^2 and 1.48 mm are 0.008 to
/// 0.08.
constexpr double kContactStiffness = 0.03;

} // namespace knittsim::physics
