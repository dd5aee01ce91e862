#pragma once

#include "core/physics/integrator.h"
#include "core/physics/preconditioner.h"

namespace knittsim::physics {

/// Overdamped motion by implicit steps, (H + mass / t) p = -gradient: one linear solve each, with a step t
/// that grows while all goes well and so ends as Newton's method. What is loose (free ends, edges that curl)
/// moves no farther in a step than it is sure of, and costs few iterations.
class ImplicitSteps final : public Integrator {
public:
    void initialise(System& model, const Motion& motion) override;
    void forcesChanged(System& model, const Motion& motion) override; ///< keeps the step size
    StepReport step(Motion& motion, const Interrupt& interrupt) override;
    bool takesLargeSteps() const override { return true; }

private:
    StepReport tryStep(Motion& motion, const Interrupt& interrupt);

    System* m_model = nullptr;
    std::unique_ptr<Preconditioner> m_preconditioner;
    Vector m_gradient;
    double m_energy = 0;
    double m_damping = 0; ///< 1/t
    bool m_fresh = true;  ///< gradient and energy are not known yet
};

} // namespace knittsim::physics
