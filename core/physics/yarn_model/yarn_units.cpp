#include "core/physics/yarn_model/yarn_units.h"

#include <algorithm>
#include <cmath>

namespace knittsim::physics {

namespace {
constexpr double kThickestCore = 0.95; ///< of the outer diameter
}

YarnUnits unitsOf(const yarn::Yarn& yarn) {
    return {yarn.outerDiameterMm, yarn.bendingStiffness};
}

RodYarn toRod(const yarn::Yarn& yarn, const YarnUnits& units) {
    RodYarn rod;
    rod.outerDiameter = yarn.outerDiameterMm / units.lengthMm;
    rod.coreDiameter = std::min(yarn.coreDiameterMm / units.lengthMm, kThickestCore * rod.outerDiameter);
    rod.axialStiffness = yarn.axialStiffnessMilliNewton / units.forceMilliNewton();
    rod.bendingStiffness = yarn.bendingStiffness / units.bendingStiffness;
    rod.contactStiffness = kContactStiffness * rod.bendingStiffness / std::pow(rod.outerDiameter, 5);
    rod.friction = yarn.friction;
    return rod;
}

} // namespace knittsim::physics
