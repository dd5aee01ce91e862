#pragma once

#include "core/physics/integrator.h"
#include "core/physics/preconditioner.h"

namespace knittsim::physics {

/// FIRE (Bitzek et al. 2006) in the metric of the Hessian's diagonal blocks: the net moves like a heavy body
/// with mass = diagonal stiffness in a time without unit, is steered towards the force and stopped when it
/// climbs. When it climbs it goes back half a step ("quick restart") before it starts anew. One force a step.
class Fire final : public Integrator {
public:
    void initialise(System& model, const Motion& motion) override;
    StepReport step(Motion& motion, const Interrupt& interrupt) override;

private:
    StepReport tryStep(Motion& motion, const Interrupt& interrupt);
    void refreshMetric(const Vector& x);
    void steer(double power);

    System* m_model = nullptr;
    std::unique_ptr<Metric> m_metric;
    Vector m_gradient;
    Vector m_descent;  ///< -D^-1 gradient
    Vector m_velocity; ///< mm per unit time
    double m_energy = 0;
    double m_timeStep = 0;
    double m_mixing = 0;
    int m_downhill = 0;
    int m_untilRefresh = 0;
    bool m_fresh = true;
};

} // namespace knittsim::physics
