#include "core/physics/lbfgs.h"

#include "core/physics/line_search.h"

namespace knittsim::physics {

namespace {
constexpr std::size_t kMemory = 8;
constexpr int kMetricLife = 40;
} // namespace

void Lbfgs::initialise(System& model, const Motion& /*motion*/) {
    m_model = &model;
    m_metric = model.makeMetric();
    m_fresh = true;
}

StepReport Lbfgs::step(Motion& motion, const Interrupt& interrupt) {
    return interruptible(*m_model, interrupt, [&] { return tryStep(motion, interrupt); });
}

void Lbfgs::start(const Vector& x) {
    m_energy = m_model->evaluate(x, &m_gradient);
    m_pairs.clear();
    m_untilRefresh = 0;
    m_fresh = false;
}

/// Two-loop recursion.
Vector Lbfgs::direction() {
    Vector q = -m_gradient;
    std::vector<double> alpha(m_pairs.size());
    for (std::size_t i = m_pairs.size(); i-- > 0;) {
        alpha[i] = m_pairs[i].inverse * m_pairs[i].move.dot(q);
        q -= alpha[i] * m_pairs[i].change;
    }
    Vector p;
    m_metric->apply(q, p);
    for (std::size_t i = 0; i < m_pairs.size(); ++i) {
        p += (alpha[i] - m_pairs[i].inverse * m_pairs[i].change.dot(p)) * m_pairs[i].move;
    }
    m_model->mask(p);
    return p;
}

void Lbfgs::remember(const Vector& move, const Vector& change) {
    const double curvature = move.dot(change);
    if (curvature <= 1e-12 * move.norm() * change.norm()) {
        return;
    }
    if (m_pairs.size() == kMemory) {
        m_pairs.pop_front();
    }
    m_pairs.push_back({move, change, 1 / curvature});
}

StepReport Lbfgs::tryStep(Motion& motion, const Interrupt& interrupt) {
    StepReport report;
    if (m_fresh) {
        start(motion.positions);
        report.evaluations = 1;
    }
    if (m_untilRefresh-- <= 0) {
        m_model->linearise(motion.positions);
        m_metric->build();
        m_untilRefresh = kMetricLife;
    }
    interrupt.check();
    Vector move = direction();
    if (move.dot(m_gradient) >= 0) {
        m_pairs.clear();
        move = direction();
    }
    LineSearch search(*m_model, motion.positions, m_energy, m_gradient);
    const bool found = search.run(move, 1, interrupt);
    report.evaluations += search.evaluations();
    report.potential = m_energy;
    report.forceNorm = m_gradient.norm();
    if (!found) {
        // The memory may be of no use any more: once more from scratch, unless that has just failed.
        report.outcome = m_pairs.empty() ? StepReport::Outcome::Stuck : StepReport::Outcome::Moved;
        m_pairs.clear();
        return report;
    }
    const Vector moved = search.positions() - motion.positions;
    remember(moved, search.gradient() - m_gradient);
    report.largestMove = moved.cwiseAbs().maxCoeff();
    motion.positions = search.positions();
    motion.velocities.setZero(moved.size());
    m_gradient = search.gradient();
    m_energy = search.energy();
    report.potential = m_energy;
    report.forceNorm = m_gradient.norm();
    return report;
}

} // namespace knittsim::physics
