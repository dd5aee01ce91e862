#include "core/physics/integrator.h"

#include "core/physics/fire.h"
#include "core/physics/implicit_steps.h"
#include "core/physics/kinsol_newton.h"
#include "core/physics/lbfgs.h"
#include "core/physics/multistep.h"
#include "core/physics/newton_cg.h"
#include "core/physics/runge_kutta.h"

#include <array>

namespace knittsim::physics {

namespace {

template<class Kind> std::unique_ptr<Integrator> make() {
    return std::make_unique<Kind>();
}

constexpr std::array kKinds{
    IntegratorKind{"newton-cg", "Newton with conjugate gradients",
                   "Finds the rest shape in few large steps; the quickest way.", make<NewtonCg>},
    IntegratorKind{"implicit", "Implicit steps",
                   "Damped steps that grow as rest comes nearer; sure from any start.", make<ImplicitSteps>},
    IntegratorKind{"fire", "FIRE", "Lets the fabric slide to rest like a damped body; smooth to watch.",
                   make<Fire>},
    IntegratorKind{"l-bfgs", "L-BFGS", "Descends with a memory of its last steps; needs forces only.",
                   make<Lbfgs>},
    IntegratorKind{"kinsol", "KINSOL Newton-PCG",
                   "Newton by SUNDIALS, with its own line search on the force.", make<KinsolNewton>},
    IntegratorKind{"cash-karp", "Cash-Karp 5(4)",
                   "The paper's method: true motion in time, with damping. Slow.", make<CashKarp>},
    IntegratorKind{"dormand-prince", "Dormand-Prince 5(4)", "True motion in time, with damping. Slow.",
                   make<DormandPrince>},
    IntegratorKind{"cvode-adams", "CVODE Adams", "True motion in time by a multistep method. Slow.",
                   make<CvodeAdams>},
    IntegratorKind{"cvode-bdf", "CVODE BDF",
                   "True motion in time by an implicit method: long steps where all is calm.",
                   make<CvodeBdf>},
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
