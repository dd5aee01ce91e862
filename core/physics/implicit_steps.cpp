#include "core/physics/implicit_steps.h"

#include "core/physics/conjugate_gradients.h"
#include "core/physics/line_search.h"

#include <algorithm>

namespace knittsim::physics {

namespace {
constexpr double kForcing = 0.1;
constexpr int kMostIterations = 200;
constexpr int kManyIterations = 100;  ///< more say that the step is too long for the preconditioner
constexpr double kFirstDamping = 0.1; ///< of stiffness over mass
constexpr double kLeastDamping = 1e-7;
constexpr double kMostDamping = 1e3;
} // namespace

void ImplicitSteps::initialise(System& model, const Motion& /*motion*/) {
    m_model = &model;
    m_damping = kFirstDamping * model.stiffnessScale() / model.mass().mean();
    m_preconditioner = model.makePreconditioner();
    m_fresh = true;
}

void ImplicitSteps::forcesChanged(System& /*model*/, const Motion& /*motion*/) {
    m_fresh = true;
}

StepReport ImplicitSteps::step(Motion& motion, const Interrupt& interrupt) {
    return interruptible(*m_model, interrupt, [&] { return tryStep(motion, interrupt); });
}

StepReport ImplicitSteps::tryStep(Motion& motion, const Interrupt& interrupt) {
    StepReport report;
    Vector& x = motion.positions;
    const Vector& mass = m_model->mass();
    if (m_fresh) {
        m_energy = m_model->evaluate(x, &m_gradient);
        m_fresh = false;
        report.evaluations = 1;
    }
    m_model->linearise(x);
    interrupt.check();
    m_preconditioner->build(m_damping);
    const auto multiply = [&](const Vector& v, Vector& y) {
        m_model->multiply(v, y);
        for (Eigen::Index e = 0; e < mass.size(); ++e) {
            y.segment<3>(3 * e) += m_damping * mass[e] * v.segment<3>(3 * e);
        }
    };
    Vector move;
    const CgResult solve = conjugateGradients(
        multiply, [&](const Vector& r, Vector& z) { m_preconditioner->apply(r, z); }, Vector(-m_gradient),
        move, kForcing, kMostIterations, interrupt, CgNorm::Preconditioner);
    m_model->mask(move);
    report.evaluations += solve.iterations;

    LineSearch search(*m_model, x, m_energy, m_gradient);
    const bool found = search.run(move, 1, interrupt);
    report.evaluations += search.evaluations();
    report.potential = m_energy;
    report.forceNorm = m_gradient.norm();
    const double scale = m_model->stiffnessScale() / mass.mean();
    const double change = !found || search.evaluations() > 2   ? 4
                          : search.evaluations() > 1           ? 1.5
                          : solve.iterations > kManyIterations ? 1.2
                                                               : 0.4;
    m_damping = std::clamp(change * m_damping, kLeastDamping * scale, kMostDamping * scale);
    if (!found) {
        // A smaller step may still find something.
        report.outcome =
            m_damping < kMostDamping * scale ? StepReport::Outcome::Moved : StepReport::Outcome::Stuck;
        return report;
    }
    report.largestMove = (search.positions() - x).cwiseAbs().maxCoeff();
    x = search.positions();
    motion.velocities.setZero(x.size());
    m_gradient = search.gradient();
    m_energy = search.energy();
    report.potential = m_energy;
    report.forceNorm = m_gradient.norm();
    return report;
}

} // namespace knittsim::physics
