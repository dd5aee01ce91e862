#pragma once

#include "core/physics/integrator.h"
#include "core/physics/stop_rule.h"
#include "core/physics/yarn_model/yarn_model.h"

#include <functional>

namespace knittsim::physics {

struct YarnRelaxOptions {
    const char* integrator = "newton-cg"; ///< an id of integratorKinds()
    double residual = 1e-3;               ///< StopRule's limit
    int mostEvaluations = 100'000;
    const std::function<bool()>* cancelled = nullptr;
};

struct YarnRelaxReport {
    StopRule::Verdict verdict = StopRule::Verdict::GoOn; ///< GoOn: cancelled, or no evaluations left
    int steps = 0;
    int evaluations = 0;
    double residual = 0;
    double energy = 0;
    StrandAudit audit; ///< at the end

    void addWork(const YarnRelaxReport& earlier) {
        steps += earlier.steps;
        evaluations += earlier.evaluations;
    }
};

/// To rest, the yarns as thick as they are.
YarnRelaxReport settleYarns(YarnModel& model, Motion& motion, const YarnRelaxOptions& options = {});

/// From strands that may be nearer than their cores to rest: with yarns so thin that no cores overlap, which
/// then grow to their true diameter as room is made for them. A cell that folds up to less than a yarn is
/// given up as Diverged.
YarnRelaxReport relaxYarns(YarnModel& model, Motion& motion, const YarnRelaxOptions& options = {});

} // namespace knittsim::physics
