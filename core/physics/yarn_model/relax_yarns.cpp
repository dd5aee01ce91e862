#include "core/physics/yarn_model/relax_yarns.h"

#include <algorithm>

namespace knittsim::physics {

namespace {
constexpr double kRoom = 1.15;   ///< smallest distance over core diameter that yarns may grow to
constexpr double kGrowth = 1.25; ///< at most, from one stage to the next
constexpr double kLeastGrowth = 1.03;
constexpr double kThinnest = 0.02;
constexpr double kNarrowest = 0.25; ///< cell over yarn diameter: below, it has folded up

bool foldedUp(const YarnModel& model, const Vector& x) {
    const std::optional<Eigen::Vector2d> cell = cellAt(x, model.cellEntry());
    return cell && !(cell->minCoeff() > kNarrowest * model.thickestDiameter());
}

struct Run {
    YarnModel& model;
    Motion& motion;
    const YarnRelaxOptions& options;
    std::unique_ptr<Integrator> integrator;
    StopRule rule;
    YarnRelaxReport report;

    Run(YarnModel& m, Motion& start, const YarnRelaxOptions& o)
        : model(m), motion(start), options(o), integrator(makeIntegrator(o.integrator)) {
        rule.setLimit(options.residual);
        rule.setReference(model);
        integrator->initialise(model, motion);
    }

    bool goesOn() const {
        return report.verdict == StopRule::Verdict::GoOn && report.evaluations < options.mostEvaluations;
    }

    /// False when it was cancelled.
    bool advance(StepReport& step) {
        step = integrator->step(motion, Interrupt(options.cancelled));
        if (step.outcome == StepReport::Outcome::Cancelled) {
            return false;
        }
        ++report.steps;
        report.evaluations += step.evaluations;
        report.residual = rule.residual(step.forceNorm);
        report.energy = step.potential;
        if (foldedUp(model, motion.positions)) {
            report.verdict = StopRule::Verdict::Diverged;
        }
        return true;
    }
};

/// From as thin as the nearest cores have room for to true thickness. False: it did not get there.
bool grow(Run& run) {
    const auto fitting = [&] {
        run.model.setThickness(1);
        const StrandAudit audit = run.model.audit(run.motion.positions);
        return audit.worstA < 0 ? 1.0 : audit.smallestDistance / (kRoom * audit.worstCore);
    };
    double thickness = std::clamp(fitting(), kThinnest, 1.0);
    run.model.setThickness(thickness);
    StepReport step;
    while (thickness < 1 && run.goesOn() && run.advance(step)) {
        thickness = std::min(1.0, std::clamp(fitting(), kLeastGrowth * thickness, kGrowth * thickness));
        run.model.setThickness(thickness);
        run.integrator->initialise(run.model, run.motion);
    }
    return thickness >= 1;
}

void settle(Run& run) {
    StepReport step;
    while (run.goesOn() && run.advance(step)) {
        if (run.report.verdict == StopRule::Verdict::GoOn) {
            run.report.verdict =
                run.rule.judge(step, run.motion.positions, run.integrator->takesLargeSteps());
        }
    }
}
} // namespace

YarnRelaxReport settleYarns(YarnModel& model, Motion& motion, const YarnRelaxOptions& options) {
    Run run(model, motion, options);
    settle(run);
    run.report.audit = model.audit(motion.positions);
    return run.report;
}

YarnRelaxReport relaxYarns(YarnModel& model, Motion& motion, const YarnRelaxOptions& options) {
    Run run(model, motion, options);
    if (grow(run)) {
        settle(run);
    }
    run.report.audit = model.audit(motion.positions);
    return run.report;
}

} // namespace knittsim::physics
