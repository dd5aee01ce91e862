#include "core/physics/real_motion.h"

#include "core/physics/multistep.h"

namespace knittsim::physics {

std::unique_ptr<Integrator> makeRealMotion(const Damping& damping) {
    auto motion = std::make_unique<CvodeBdf>();
    motion->setDamping(damping);
    return motion;
}

} // namespace knittsim::physics
