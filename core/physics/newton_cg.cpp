#include "core/physics/newton_cg.h"

#include "core/physics/conjugate_gradients.h"
#include "core/physics/line_search.h"

#include <algorithm>

namespace knittsim::physics {

namespace {
constexpr int kMostIterations = 400;
} // namespace

void NewtonCg::initialise(System& model, const Motion& /*motion*/) {
    m_model = &model;
    m_fresh = true;
}

StepReport NewtonCg::step(Motion& motion, const Interrupt& interrupt) {
    return interruptible(*m_model, interrupt, [&] { return tryStep(motion, interrupt); });
}

StepReport NewtonCg::tryStep(Motion& motion, const Interrupt& interrupt) {
    StepReport report;
    Vector& x = motion.positions;
    if (m_fresh) {
        m_preconditioner = m_model->makePreconditioner();
        interrupt.check();
        m_energy = m_model->evaluate(x, &m_gradient);
        m_lastNorm = m_gradient.norm();
        m_fresh = false;
        report.evaluations = 1;
    }
    const double norm = m_gradient.norm();
    m_model->linearise(x);
    m_preconditioner->build();
    interrupt.check();

    const double ratio = m_lastNorm > 0 ? norm / m_lastNorm : 1;
    const double forcing = std::clamp(0.5 * ratio * ratio, 0.02, 0.2);
    Vector move;
    const CgResult solve =
        conjugateGradients([&](const Vector& v, Vector& y) { m_model->multiply(v, y); },
                           [&](const Vector& r, Vector& z) { m_preconditioner->apply(r, z); },
                           Vector(-m_gradient), move, forcing, kMostIterations, interrupt);
    m_model->mask(move);
    report.evaluations += solve.iterations;

    report.potential = m_energy;
    report.forceNorm = norm;
    LineSearch search(*m_model, x, m_energy, m_gradient);
    const bool found = search.run(move, 1, interrupt);
    report.evaluations += search.evaluations();
    if (!found) {
        report.outcome = StepReport::Outcome::Stuck;
        return report;
    }
    report.largestMove = (search.positions() - x).cwiseAbs().maxCoeff();
    x = search.positions();
    motion.velocities.setZero(x.size());
    m_gradient = search.gradient();
    m_energy = search.energy();
    m_lastNorm = norm;
    report.potential = m_energy;
    report.forceNorm = m_gradient.norm();
    return report;
}

} // namespace knittsim::physics
