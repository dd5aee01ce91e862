#include "core/physics/fire.h"

#include <algorithm>
#include <cmath>

namespace knittsim::physics {

namespace {
constexpr double kFirstTimeStep = 0.3;
constexpr double kLargestTimeStep = 1.1; // of about 1.4, where an explicit step in this metric turns unstable
constexpr double kFirstMixing = 0.1;
constexpr int kDownhillBeforeGrowth = 5;
constexpr int kMetricLife = 40;
constexpr double kDistortion = 0.1; // a step; a viewer sees several in one picture
} // namespace

void Fire::initialise(System& model, const Motion& /*motion*/) {
    m_model = &model;
    m_metric = model.makeMetric();
    m_fresh = true;
}

StepReport Fire::step(Motion& motion, const Interrupt& interrupt) {
    const StepReport report = interruptible(*m_model, interrupt, [&] { return tryStep(motion, interrupt); });
    m_fresh = m_fresh || report.outcome == StepReport::Outcome::Cancelled;
    return report;
}

void Fire::refreshMetric(const Vector& x) {
    m_model->linearise(x);
    m_metric->build();
    m_untilRefresh = kMetricLife;
}

/// Velocity towards the force; `power` > 0 is the work done on the net.
void Fire::steer(double power) {
    if (power > 0) {
        const double descent = m_descent.norm();
        const double ratio = descent > 0 ? m_velocity.norm() / descent : 0;
        m_velocity = (1 - m_mixing) * m_velocity + (m_mixing * ratio) * m_descent;
        if (++m_downhill > kDownhillBeforeGrowth) {
            m_timeStep = std::min(1.1 * m_timeStep, kLargestTimeStep);
            m_mixing *= 0.99;
        }
    } else {
        m_velocity.setZero();
        m_timeStep = std::max(0.5 * m_timeStep, 0.1 * kFirstTimeStep);
        m_mixing = kFirstMixing;
        m_downhill = 0;
    }
}

StepReport Fire::tryStep(Motion& motion, const Interrupt& interrupt) {
    Vector x = motion.positions;
    StepReport report;
    if (m_fresh) {
        m_energy = m_model->evaluate(x, &m_gradient);
        m_velocity.setZero(x.size());
        m_timeStep = kFirstTimeStep;
        m_mixing = kFirstMixing;
        m_downhill = 0;
        m_untilRefresh = 0;
        m_fresh = false;
        report.evaluations = 1;
    }
    if (m_untilRefresh-- <= 0) {
        refreshMetric(x);
    }
    interrupt.check();
    m_metric->apply(m_gradient, m_descent);
    m_descent *= -1;
    const double power = -m_gradient.dot(m_velocity);
    if (power < 0) {
        Vector back = -0.5 * m_timeStep * m_velocity;
        m_model->shorten(x, back, kDistortion);
        x += back;
    }
    steer(power);
    m_velocity += m_timeStep * m_descent;
    Vector move = m_timeStep * m_velocity;
    m_model->mask(move);
    m_model->shorten(x, move, kDistortion);
    m_velocity = move / m_timeStep;
    x += move;
    m_energy = m_model->evaluate(x, &m_gradient);
    ++report.evaluations;
    motion.positions.swap(x);
    motion.velocities.setZero(move.size());
    report.potential = m_energy;
    report.kinetic = m_metric->halfSquare(m_velocity);
    report.forceNorm = m_gradient.norm();
    report.largestMove = move.cwiseAbs().maxCoeff();
    return report;
}

} // namespace knittsim::physics
