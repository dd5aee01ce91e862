#include "core/physics/yarn_model/relax_yarns.h"

#include <algorithm>

namespace knittsim::physics {

namespace {
constexpr double kRoom = 1.15;   ///< smallest distance over core diameter that yarns may grow to
constexpr double kGrowth = 1.25; ///< at most, from one stage to the next
constexpr double kLeastGrowth = 1.03;
constexpr int kStepsPerStage = 1;
constexpr double kThinnest = 0.02;
constexpr double kNarrowest = 0.25; ///< cell over yarn diameter: below, it has folded up

bool foldedUp(const YarnModel& model, const Vector& x) {
    const std::optional<Eigen::Vector2d> cell = cellAt(x, model.cellEntry());
    return cell && !(cell->minCoeff() > kNarrowest * model.thickestDiameter());
}
} // namespace

YarnRelaxReport relaxYarns(YarnModel& model, Motion& motion, const YarnRelaxOptions& options) {
    YarnRelaxReport report;
    const auto integrator = makeIntegrator(options.integrator);
    StopRule rule;
    rule.setLimit(options.residual);
    rule.setReference(model);

    // The thickness at which the nearest cores still have room between them.
    const auto fitting = [&] {
        model.setThickness(1);
        const StrandAudit audit = model.audit(motion.positions);
        return audit.worstA < 0 ? 1.0 : audit.smallestDistance / (kRoom * audit.worstCore);
    };
    double thickness = std::clamp(fitting(), kThinnest, 1.0);
    model.setThickness(thickness);
    integrator->initialise(model, motion);
    int stageSteps = 0;
    while (report.evaluations < options.mostEvaluations) {
        const StepReport step = integrator->step(motion, Interrupt(options.cancelled));
        if (step.outcome == StepReport::Outcome::Cancelled) {
            break;
        }
        ++report.steps;
        report.evaluations += step.evaluations;
        report.residual = rule.residual(step.forceNorm);
        report.energy = step.potential;
        if (foldedUp(model, motion.positions)) {
            report.verdict = StopRule::Verdict::Diverged;
            break;
        }
        if (thickness < 1) {
            if (++stageSteps < kStepsPerStage && step.outcome == StepReport::Outcome::Moved) {
                continue;
            }
            thickness = std::clamp(fitting(), kLeastGrowth * thickness, kGrowth * thickness);
            thickness = std::min(thickness, 1.0);
            model.setThickness(thickness);
            integrator->initialise(model, motion);
            rule.restart();
            stageSteps = 0;
            continue;
        }
        report.verdict = rule.judge(step, motion.positions, integrator->takesLargeSteps());
        if (report.verdict != StopRule::Verdict::GoOn) {
            break;
        }
    }
    report.audit = model.audit(motion.positions);
    return report;
}

} // namespace knittsim::physics
