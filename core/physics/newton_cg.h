#pragma once

#include "core/physics/integrator.h"
#include "core/physics/preconditioner.h"

namespace knittsim::physics {

/// Inexact Newton: H p = -gradient with the positive semi-definite Hessian by preconditioned conjugate
/// gradients, only as exactly as the present distance from rest deserves (Eisenstat and Walker), then a step
/// along p that lowers the energy.
class NewtonCg final : public Integrator {
public:
    void initialise(System& model, const Motion& motion) override;
    StepReport step(Motion& motion, const Interrupt& interrupt) override;
    bool takesLargeSteps() const override { return true; }

private:
    StepReport tryStep(Motion& motion, const Interrupt& interrupt);

    System* m_model = nullptr;
    std::unique_ptr<Preconditioner> m_preconditioner;
    Vector m_gradient;
    double m_energy = 0;
    double m_lastNorm = 0;
    bool m_fresh = true; ///< gradient and energy are not known yet
};

} // namespace knittsim::physics
