#pragma once

#include "core/physics/integrator.h"
#include "core/physics/preconditioner.h"
#include "core/physics/sundials_support.h"

#include <sundials/sundials_linearsolver.h>

namespace knittsim::physics {

/// KINSOL: Newton on force = 0 with a line search, linear systems by its preconditioned conjugate gradients;
/// one Newton iteration a step.
class KinsolNewton final : public Integrator {
public:
    KinsolNewton() = default;
    ~KinsolNewton() override;
    KinsolNewton(const KinsolNewton&) = delete;
    KinsolNewton& operator=(const KinsolNewton&) = delete;

    void initialise(System& model, const Motion& motion) override;
    StepReport step(Motion& motion, const Interrupt& interrupt) override;
    bool takesLargeSteps() const override { return true; }

    // For KINSOL's callbacks: 0 done, -1 interrupted.
    int gradient(N_Vector x, N_Vector result);
    int product(N_Vector v, N_Vector result);
    int setUp(N_Vector x);
    int precondition(N_Vector v);

private:
    void create();
    void release();
    template<class Work> int guarded(Work work);
    StepReport finish(Motion& motion, int flag);

    sundials::Context m_context;
    std::unique_ptr<sundials::StateVector> m_x, m_ones;
    void* m_memory = nullptr;
    SUNLinearSolver m_linear = nullptr;
    System* m_model = nullptr;
    std::unique_ptr<Preconditioner> m_preconditioner;
    Interrupt m_interrupt;
    Vector m_in, m_out;
    int m_evaluations = 0;
};

} // namespace knittsim::physics
