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

/// To rest, step by step. A cell that folds up to less than a yarn is given up as Diverged.
class YarnRelaxation {
public:
    enum class Start {
        Thin, ///< strands may be nearer than their cores: yarns grow as room is made for them
        Thick ///< yarns are as thick as the model has them
    };

    /// Model and motion must outlive it; nobody else moves them.
    YarnRelaxation(YarnModel& model, Motion& motion, const char* integrator, double residual,
                   Start start = Start::Thin);

    /// One step of the integrator. False when there is nothing more to do: see report().verdict.
    bool step(const Interrupt& interrupt);

    /// To be called when a term of the model has changed since the last step.
    void forcesChanged() { m_integrator->forcesChanged(m_model, m_motion); }

    /// Likewise, when what was at rest is to move again.
    void restart() {
        forcesChanged();
        m_rule.restart();
        m_report.verdict = StopRule::Verdict::GoOn;
    }

    /// Residuals are from now on those of this force, as a norm over all nodes, EI/d^2.
    void measureAgainst(double force) { m_rule.setReference(m_model, force); }
    double residual(double force) const { return m_rule.residual(force); }

    /// Without the audit.
    const YarnRelaxReport& report() const { return m_report; }
    const StepReport& last() const { return m_last; }
    bool takesLargeSteps() const { return m_integrator->takesLargeSteps(); }

private:
    double fitting();
    void grow();

    YarnModel& m_model;
    Motion& m_motion;
    std::unique_ptr<Integrator> m_integrator;
    StopRule m_rule;
    YarnRelaxReport m_report;
    StepReport m_last;
    double m_thickness = 1;
};

/// All steps from yarns as thick as they are, then the audit.
YarnRelaxReport settleYarns(YarnModel& model, Motion& motion, const YarnRelaxOptions& options = {});

/// All steps from thin yarns, then the audit.
YarnRelaxReport relaxYarns(YarnModel& model, Motion& motion, const YarnRelaxOptions& options = {});

} // namespace knittsim::physics
