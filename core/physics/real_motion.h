#pragma once

#include "core/physics/integrator.h"

#include <memory>

namespace knittsim::physics {

/// How fast motion dies, in the units of time of the system.
struct Damping {
    double massRate = 0;      ///< a, 1/time: all motion, as in air
    double stiffnessTime = 0; ///< b, time: the quicker a wave, the more, as friction within yarn
};

/// True motion of a system in time, M x'' = F(x) - b H x' - a M x' (CVODE, BDF): what falls, swings or is let
/// go does so as fast as its mass says. One step of the method a step; Motion::time goes on.
std::unique_ptr<Integrator> makeRealMotion(const Damping& damping);

} // namespace knittsim::physics
