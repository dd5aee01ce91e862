#pragma once

#include "core/physics/system.h"

#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace knittsim::physics {

/// Shape and motion of a fabric (units of the bonding-point model; the yarn model has its own); what one
/// integrator hands to the next.
struct Motion {
    Vector positions;  ///< mm
    Vector velocities; ///< mm/s; 0 for integrators without time
    double time = 0;   ///< s
};

/// What one step did.
struct StepReport {
    enum class Outcome {
        Moved,
        Stuck,     ///< no better shape found
        Failed,    ///< the method gave up, see note
        Cancelled, ///< interrupted; nothing changed
    } outcome = Outcome::Moved;
    double stepSize = 0;    ///< s, 0 without time
    double potential = 0;   ///< uJ, at the new shape
    double kinetic = 0;     ///< uJ
    double forceNorm = 0;   ///< mN, at the new shape
    double largestMove = 0; ///< mm
    int evaluations = 0;    ///< of forces, with Hessian products counted as one each
    std::string note{};
};

/// Runs one step with the model listening to `interrupt`; an interruption becomes a report.
template<class Step> StepReport interruptible(System& model, const Interrupt& interrupt, Step step) {
    StepReport report;
    model.setInterrupt(interrupt);
    try {
        report = step();
    } catch (const Interrupted&) {
        report.outcome = StepReport::Outcome::Cancelled;
    }
    model.setInterrupt(Interrupt());
    return report;
}

/// One way to bring a model to rest. Deterministic. Nothing is thrown.
class Integrator {
public:
    virtual ~Integrator() = default;

    /// Starts at a motion; also after the model's pins, pulls or yarns, or the shape have changed from
    /// outside. The model must outlive the integrator or the next call.
    virtual void initialise(System& model, const Motion& motion) = 0;

    /// Another term of the same model has changed, not the motion: an integrator may keep what it has
    /// learned.
    virtual void forcesChanged(System& model, const Motion& motion) { initialise(model, motion); }

    /// Moves on from where the last step left `motion`.
    virtual StepReport step(Motion& motion, const Interrupt& interrupt) = 0;

    /// True when one step changes the picture visibly, so that a viewer wants to see every one.
    virtual bool takesLargeSteps() const { return false; }
};

/// What there is to choose from; the first one is the default.
struct IntegratorKind {
    const char* id;
    const char* name;
    const char* purpose;
    std::unique_ptr<Integrator> (*make)();
};
std::span<const IntegratorKind> integratorKinds();

/// Null when there is no such id.
std::unique_ptr<Integrator> makeIntegrator(std::string_view id);

/// No spring changes its vector by more than this share of its length in one step, so that a viewer can
/// follow and nothing turns inside out.
constexpr double kLargestDistortion = 0.25;

} // namespace knittsim::physics
