#include "core/physics/time_stepper.h"

#include <utility>

namespace knittsim::physics {

namespace {
constexpr int kFreezeInterval = 50; // steps
} // namespace

void TimeStepper::initialise(System& model, const Motion& /*motion*/) {
    m_model = &model;
    m_attached = false;
    m_ready = false;
}

void TimeStepper::start(const Motion& motion) {
    if (!m_attached) {
        m_dynamics.attach(*m_model, motion, m_damping);
        m_attached = true;
    } else {
        m_dynamics.freeze(motion.positions);
    }
    if (m_y == nullptr || m_y->map().size() != m_dynamics.size()) {
        m_y = std::make_unique<sundials::StateVector>(m_dynamics.size(), m_context);
    }
    m_dynamics.pack(motion, m_y->map());
    m_scaledTime = 0;
    m_untilFreeze = kFreezeInterval;
    create(m_y->get());
    m_ready = true;
}

StepReport TimeStepper::step(Motion& motion, const Interrupt& interrupt) {
    m_interrupt = interrupt;
    StepReport report = interruptible(*m_model, interrupt, [&] { return tryStep(motion, interrupt); });
    m_interrupt = Interrupt();
    if (report.outcome != StepReport::Outcome::Moved) {
        m_ready = false; // begins anew from `motion`
    }
    return report;
}

StepReport TimeStepper::tryStep(Motion& motion, const Interrupt& interrupt) {
    int flag = 0;
    if (!m_ready) {
        start(motion);
    } else if (m_untilFreeze-- <= 0) {
        m_dynamics.freeze(motion.positions);
        m_untilFreeze = kFreezeInterval;
        flag = reset(m_scaledTime, m_y->get());
    }
    const double begin = m_scaledTime;
    if (flag >= 0) {
        flag = advance(m_y->get(), m_scaledTime);
    }
    interrupt.check();
    if (sundials::meaningOf(m_package, flag) != sundials::Meaning::Fine) {
        StepReport report;
        report.outcome = StepReport::Outcome::Failed;
        report.note = sundials::nameOf(m_package, flag);
        return report;
    }
    Motion next;
    m_dynamics.unpack(m_y->map(), next);
    next.time = motion.time + (m_scaledTime - begin) / m_dynamics.frequency();
    const StepReport report = m_dynamics.report(next, motion.positions, lastStep());
    std::swap(motion, next);
    return report;
}

} // namespace knittsim::physics
