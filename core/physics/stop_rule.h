#pragma once

#include "core/physics/integrator.h"

#include <cstdint>

namespace knittsim::physics {

/// Decides after each step whether a model is at rest.
class StopRule {
public:
    enum class Verdict { GoOn, ResidualReached, Stagnation, StepLimit, Diverged, SolverFailed };

    /// Measures forces against those at the shape `start` (the machine's positions), or against a small share
    /// of what the springs can do where the start is at rest already. Call again when the model's yarns
    /// change.
    void setReference(const System& model, const Vector& start);

    /// Measures forces against what the system's yarns can do when bent or stretched a little: where the
    /// first forces say nothing, because the start is arbitrary.
    void setReference(const System& model);

    /// Measures forces against this one, > 0, mN.
    void setReference(const System& model, double force);

    /// Forgets the past steps; the reference stays.
    void restart();

    /// Norm of the force relative to the reference.
    double residual(double forceNorm) const { return forceNorm / m_reference; }

    void setLimit(double residual) { m_limit = residual; }

    Verdict judge(const StepReport& report, const Vector& positions, bool largeSteps);

private:
    bool stagnates(const StepReport& report, const Vector& positions, int window);

    double m_limit = 1e-3;
    double m_reference = 1;       ///< mN
    double m_referenceEnergy = 0; ///< uJ
    double m_shapeTolerance = 0;  ///< mm
    std::int64_t m_steps = 0;
    int m_stuck = 0;
    double m_windowEnergy = 0;
    Vector m_windowPositions;
};

/// Residual reached or stagnation.
constexpr bool isAtRest(StopRule::Verdict verdict) {
    return verdict == StopRule::Verdict::ResidualReached || verdict == StopRule::Verdict::Stagnation;
}

} // namespace knittsim::physics
