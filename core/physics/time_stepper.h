#pragma once

#include "core/physics/damped_dynamics.h"
#include "core/physics/sundials_support.h"

#include <memory>

namespace knittsim::physics {

/// What the time integrators of SUNDIALS have in common: the equations, the state vector, interruption inside
/// SUNDIALS' calls, and a Hessian for the damping that is renewed now and then.
class TimeStepper : public Integrator {
public:
    void initialise(System& model, const Motion& motion) override;
    StepReport step(Motion& motion, const Interrupt& interrupt) override;

    /// Real motion rather than the way to rest; before initialise().
    void setDamping(const Damping& damping) { m_damping = damping; }

    /// For SUNDIALS' callbacks: runs `work`; 0 when done, -1 when interrupted or out of memory.
    template<class Work> int guarded(Work work) {
        try {
            m_interrupt.check();
            work(m_dynamics);
            return 0;
        } catch (...) {
            return -1;
        }
    }

protected:
    explicit TimeStepper(sundials::Package package) : m_package(package) {}

    /// A new solver at the present y and scaled time 0.
    virtual void create(N_Vector y) = 0;
    /// The solver has lost its past: y was changed or the equations have a new H.
    virtual int reset(double scaledTime, N_Vector y) = 0;
    virtual int advance(N_Vector y, double& scaledTime) = 0;
    virtual double lastStep() const = 0;

    SUNContext context() const { return m_context.get(); }
    const Interrupt& interrupt() const { return m_interrupt; }
    DampedDynamics& dynamics() { return m_dynamics; }

    /// Errors per step, mm. On the way to rest: so small against a stitch that the shape is smooth, and no
    /// smaller. For real motion velocities count, which are small in units of the highest frequency.
    double absoluteTolerance() const {
        return (m_damping ? kTrueTolerance : kTolerance) * m_dynamics.model().lengthScale();
    }
    static constexpr double kRelativeTolerance = 1e-6;
    static constexpr double kTolerance = 2e-3;
    static constexpr double kTrueTolerance = 1e-6;

private:
    StepReport tryStep(Motion& motion, const Interrupt& interrupt);
    void start(const Motion& motion);

    sundials::Package m_package;
    sundials::Context m_context;
    std::unique_ptr<sundials::StateVector> m_y;
    DampedDynamics m_dynamics;
    std::optional<Damping> m_damping;
    Interrupt m_interrupt;
    double m_scaledTime = 0;
    int m_untilFreeze = 0;
    System* m_model = nullptr;
    bool m_attached = false;
    bool m_ready = false;
};

} // namespace knittsim::physics
