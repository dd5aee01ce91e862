#include "core/physics/stop_rule.h"

#include <algorithm>
#include <cmath>

namespace knittsim::physics {

namespace {
/// Springs that are off by this share of their length set the scale of force where the start is at rest.
constexpr double kSmallStrain = 0.02;
/// Energy and shape (relative to spring lengths) that change less than this over a window stand still.
constexpr double kEnergyTolerance = 1e-7;
constexpr double kShapeTolerance = 1e-4;
constexpr int kLargeStepWindow = 8;
constexpr int kSmallStepWindow = 400;
constexpr std::int64_t kLargeStepLimit = 2'000;
constexpr std::int64_t kSmallStepLimit = 1'000'000;
} // namespace

void StopRule::setReference(const System& model) {
    const double spring = kSmallStrain * model.stiffnessScale() * model.lengthScale();
    m_reference = std::max(1e-12, spring * std::sqrt(static_cast<double>(model.entryCount())));
    m_referenceEnergy = m_reference * m_reference / model.stiffnessScale();
    m_shapeTolerance = kShapeTolerance * model.lengthScale();
    restart();
}

void StopRule::setReference(const System& model, double force) {
    setReference(model);
    m_reference = std::max(1e-12, force);
    m_referenceEnergy = m_reference * m_reference / model.stiffnessScale();
}

void StopRule::setReference(const System& model, const Vector& start) {
    setReference(model);
    Vector gradient;
    const double energy = model.evaluate(start, &gradient);
    const double norm = gradient.norm();
    if (std::isfinite(norm)) {
        m_reference = std::max(m_reference, norm);
    }
    m_referenceEnergy = std::max(energy, m_reference * m_reference / model.stiffnessScale());
}

void StopRule::restart() {
    m_steps = 0;
    m_stuck = 0;
    m_windowPositions.resize(0);
}

bool StopRule::stagnates(const StepReport& report, const Vector& positions, int window) {
    if (m_windowPositions.size() == positions.size() && m_steps % window != 0) {
        return false;
    }
    const double energy = report.potential + report.kinetic;
    const bool still = m_windowPositions.size() == positions.size() && m_steps > window &&
                       std::abs(energy - m_windowEnergy) <= kEnergyTolerance * std::abs(m_windowEnergy) &&
                       (positions - m_windowPositions).lpNorm<Eigen::Infinity>() <= m_shapeTolerance;
    m_windowEnergy = energy;
    m_windowPositions = positions;
    return still;
}

StopRule::Verdict StopRule::judge(const StepReport& report, const Vector& positions, bool largeSteps) {
    if (report.outcome == StepReport::Outcome::Cancelled) {
        return Verdict::GoOn;
    }
    if (report.outcome == StepReport::Outcome::Failed) {
        return Verdict::SolverFailed;
    }
    if (!std::isfinite(report.potential) || !std::isfinite(report.forceNorm) || !positions.allFinite()) {
        return Verdict::Diverged;
    }
    ++m_steps;
    // Passing the rest shape at speed is not rest.
    const bool slow = report.kinetic <= 10 * m_limit * m_limit * m_referenceEnergy;
    if (residual(report.forceNorm) <= m_limit && slow) {
        return Verdict::ResidualReached;
    }
    m_stuck = report.outcome == StepReport::Outcome::Stuck ? m_stuck + 1 : 0;
    if (m_stuck >= 2 || stagnates(report, positions, largeSteps ? kLargeStepWindow : kSmallStepWindow)) {
        return Verdict::Stagnation;
    }
    return m_steps >= (largeSteps ? kLargeStepLimit : kSmallStepLimit) ? Verdict::StepLimit : Verdict::GoOn;
}

} // namespace knittsim::physics
