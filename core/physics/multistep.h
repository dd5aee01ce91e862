#pragma once

#include "core/physics/preconditioner.h"
#include "core/physics/time_stepper.h"

#include <sundials/sundials_linearsolver.h>
#include <sundials/sundials_nonlinearsolver.h>

namespace knittsim::physics {

/// Linear multistep methods through CVODE; one step of the method a step. Adams solves its equations by
/// fixed-point iteration, BDF by Newton with SPGMR. The preconditioner of BDF eliminates the positions, which
/// leaves H + m M for the velocities, and solves that by a few conjugate gradients.
class Multistep : public TimeStepper {
public:
    enum class Method { Adams, Bdf };

    explicit Multistep(Method method) : TimeStepper(sundials::Package::Cvode), m_method(method) {}
    ~Multistep() override;
    Multistep(const Multistep&) = delete;
    Multistep& operator=(const Multistep&) = delete;

    // For CVODE's callbacks; `gamma` as CVODE defines it (I - gamma J).
    int setUp(double gamma);
    int solve(double gamma, Eigen::Ref<const Vector> r, Eigen::Ref<Vector> z);

private:
    void create(N_Vector y) override;
    int reset(double scaledTime, N_Vector y) override;
    int advance(N_Vector y, double& scaledTime) override;
    double lastStep() const override;
    void release();
    void useFixedPoint(N_Vector y);
    void useNewtonKrylov(N_Vector y);

    Method m_method;
    void* m_memory = nullptr;
    SUNNonlinearSolver m_nonlinear = nullptr;
    SUNLinearSolver m_linear = nullptr;
    std::unique_ptr<Preconditioner> m_preconditioner;
    Vector m_mass; ///< by coordinate, kg
};

struct CvodeAdams final : Multistep {
    CvodeAdams() : Multistep(Method::Adams) {}
};

struct CvodeBdf final : Multistep {
    CvodeBdf() : Multistep(Method::Bdf) {}
};

} // namespace knittsim::physics
