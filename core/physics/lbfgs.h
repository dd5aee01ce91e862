#pragma once

#include "core/physics/integrator.h"
#include "core/physics/preconditioner.h"

#include <deque>

namespace knittsim::physics {

/// Limited-memory BFGS that starts from the Hessian's diagonal blocks, with a step that lowers the energy.
class Lbfgs final : public Integrator {
public:
    void initialise(System& model, const Motion& motion) override;
    StepReport step(Motion& motion, const Interrupt& interrupt) override;

private:
    /// Change of shape and of gradient in an earlier step.
    struct Pair {
        Vector move;
        Vector change;
        double inverse = 0; ///< 1 / (move . change)
    };

    StepReport tryStep(Motion& motion, const Interrupt& interrupt);
    void start(const Vector& x);
    Vector direction();
    void remember(const Vector& move, const Vector& change);

    System* m_model = nullptr;
    std::unique_ptr<Metric> m_metric;
    std::deque<Pair> m_pairs;
    Vector m_gradient;
    double m_energy = 0;
    int m_untilRefresh = 0;
    bool m_fresh = true;
};

} // namespace knittsim::physics
