#include "core/physics/yarn_model/relax_yarns.h"

#include <algorithm>

namespace knittsim::physics {

namespace {
constexpr double kRoom = 1.15;   ///< smallest distance over core diameter that yarns may grow to
constexpr double kGrowth = 1.25; ///< at most, from one step to the next
constexpr double kLeastGrowth = 1.03;
constexpr double kThinnest = 0.02;
constexpr double kNarrowest = 0.25; ///< cell over yarn diameter: below, it has folded up

bool foldedUp(const YarnModel& model, const Vector& x) {
    const std::optional<Eigen::Vector2d> cell = cellAt(x, model.cellEntry());
    return cell && !(cell->minCoeff() > kNarrowest * model.thickestDiameter());
}
} // namespace

YarnRelaxation::YarnRelaxation(YarnModel& model, Motion& motion, const char* integrator, double residual,
                               Start start)
    : m_model(model), m_motion(motion), m_integrator(makeIntegrator(integrator)) {
    m_rule.setLimit(residual);
    m_rule.setReference(model);
    if (start == Start::Thin) {
        m_thickness = std::clamp(fitting(), kThinnest, 1.0);
        m_model.setThickness(m_thickness);
    }
    m_integrator->initialise(m_model, m_motion);
}

/// The thickness at which the nearest cores still have room between them.
double YarnRelaxation::fitting() {
    m_model.setThickness(1);
    const StrandAudit audit = m_model.audit(m_motion.positions);
    return audit.worstA < 0 ? 1.0 : audit.smallestDistance / (kRoom * audit.worstCore);
}

void YarnRelaxation::grow() {
    m_thickness = std::clamp(fitting(), kLeastGrowth * m_thickness, kGrowth * m_thickness);
    m_thickness = std::min(m_thickness, 1.0);
    m_model.setThickness(m_thickness);
    forcesChanged();
    m_rule.restart();
}

bool YarnRelaxation::step(const Interrupt& interrupt) {
    m_last = m_integrator->step(m_motion, interrupt);
    if (m_last.outcome == StepReport::Outcome::Cancelled) {
        return false;
    }
    ++m_report.steps;
    m_report.evaluations += m_last.evaluations;
    m_report.residual = m_rule.residual(m_last.forceNorm);
    m_report.energy = m_last.potential;
    if (foldedUp(m_model, m_motion.positions)) {
        m_report.verdict = StopRule::Verdict::Diverged;
        return false;
    }
    if (m_thickness < 1) {
        grow();
        return true;
    }
    m_report.verdict = m_rule.judge(m_last, m_motion.positions, m_integrator->takesLargeSteps());
    return m_report.verdict == StopRule::Verdict::GoOn;
}

namespace {
YarnRelaxReport toTheEnd(YarnModel& model, Motion& motion, const YarnRelaxOptions& options,
                         YarnRelaxation::Start start) {
    YarnRelaxation relaxation(model, motion, options.integrator, options.residual, start);
    while (relaxation.report().evaluations < options.mostEvaluations &&
           relaxation.step(Interrupt(options.cancelled))) {
    }
    YarnRelaxReport report = relaxation.report();
    report.audit = model.audit(motion.positions);
    return report;
}
} // namespace

YarnRelaxReport settleYarns(YarnModel& model, Motion& motion, const YarnRelaxOptions& options) {
    return toTheEnd(model, motion, options, YarnRelaxation::Start::Thick);
}

YarnRelaxReport relaxYarns(YarnModel& model, Motion& motion, const YarnRelaxOptions& options) {
    return toTheEnd(model, motion, options, YarnRelaxation::Start::Thin);
}

} // namespace knittsim::physics
