#include "core/physics/yarn_model/load_step.h"

namespace knittsim::physics {

YarnRelaxReport makeLoadStep(YarnModel& model, FrictionTerm& friction, Motion& motion,
                             const LoadStepOptions& options) {
    YarnRelaxReport sum;
    friction.holdAt(motion.positions);
    for (int round = 0; round < options.mostLags; ++round) {
        const Vector before = motion.positions;
        friction.lag(model.contact(), model.cores(), before);
        YarnRelaxReport report = settleYarns(model, motion, options.relax);
        report.steps += sum.steps;
        report.evaluations += sum.evaluations;
        sum = report;
        const double moved =
            (motion.positions - before).head(3 * model.nodeCount()).lpNorm<Eigen::Infinity>();
        const bool settled =
            sum.verdict == StopRule::Verdict::ResidualReached || sum.verdict == StopRule::Verdict::Stagnation;
        if (!settled || moved < options.stillness) {
            break;
        }
    }
    return sum;
}

} // namespace knittsim::physics
