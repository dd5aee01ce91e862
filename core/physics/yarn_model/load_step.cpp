#include "core/physics/yarn_model/load_step.h"

#include <algorithm>
#include <cmath>

namespace knittsim::physics {

namespace {

constexpr int kMostLags = 4;      ///< in one piece
constexpr double kKnown = 2e-3;   ///< change of the friction of all contacts by which it is known
constexpr int kPatience = 3;      ///< still pieces with pressures that go to and fro
constexpr double kViscous = 0.02; ///< share of the friction that may be viscous at rest

} // namespace

YarnRelaxReport makeLoadStep(YarnModel& model, FrictionTerm* friction, Motion& motion,
                             const LoadStepOptions& options) {
    if (friction == nullptr) {
        return settleYarns(model, motion, options.relax);
    }
    YarnRelaxReport sum;
    double doubling = options.mostSlip;
    int stillPieces = 0;
    for (int piece = 0; piece < options.mostPieces; ++piece) {
        friction->holdAt(motion.positions);
        friction->setDoublingSlip(doubling);
        friction->lag(model.contact(), model.cores(), motion.positions);
        bool known = false;
        for (int lags = 0; lags < kMostLags && !known; ++lags) {
            YarnRelaxReport report = settleYarns(model, motion, options.relax);
            report.addWork(sum);
            sum = report;
            if (!isAtRest(sum.verdict)) {
                return sum;
            }
            const double before = friction->limit();
            friction->lag(model.contact(), model.cores(), motion.positions);
            known = std::abs(friction->limit() - before) <= kKnown * before;
        }
        const double slip = friction->largestSlip(motion.positions);
        const bool still = slip < options.stillness && slip < kViscous * doubling;
        stillPieces = still ? stillPieces + 1 : 0;
        if (still && (known || stillPieces >= kPatience)) {
            return sum;
        }
        doubling *= slip > options.mostSlip ? 0.5 : 2;
    }
    sum.verdict = StopRule::Verdict::StepLimit;
    return sum;
}

FrictionTerm* addFriction(YarnModel& model, const YarnChains& chains) {
    const auto rough = [](const RodYarn& yarn) { return yarn.friction > 0; };
    if (std::none_of(chains.yarns.begin(), chains.yarns.end(), rough)) {
        return nullptr;
    }
    auto term = std::make_unique<FrictionTerm>(chains);
    FrictionTerm* const friction = term.get();
    model.add(std::move(term));
    return friction;
}

} // namespace knittsim::physics
