#include "core/physics/integrator.h"

#include "core/physics/fire.h"
#include "core/physics/lbfgs.h"
#include "core/physics/newton_cg.h"

#include <array>

namespace knittsim::physics {

namespace {

template<class Kind> std::unique_ptr<Integrator> make() {
    return std::make_unique<Kind>();
}

constexpr std::array kKinds{
    IntegratorKind{"newton-cg", "Newton with conjugate gradients",
                   "Finds the rest shape in few large steps; the quickest way.", make<NewtonCg>},
    IntegratorKind{"fire", "FIRE", "Lets the fabric slide to rest like a damped body; smooth to watch.",
                   make<Fire>},
    IntegratorKind{"l-bfgs", "L-BFGS", "Descends with a memory of its last steps; needs forces only.",
                   make<Lbfgs>},
};

} // namespace

std::span<const IntegratorKind> integratorKinds() {
    return kKinds;
}

std::unique_ptr<Integrator> makeIntegrator(std::string_view id) {
    for (const IntegratorKind& kind : kKinds) {
        if (id == kind.id) {
            return kind.make();
        }
    }
    return nullptr;
}

} // namespace knittsim::physics
