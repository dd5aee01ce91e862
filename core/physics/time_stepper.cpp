#include "core/physics/time_stepper.h"

namespace knittsim::physics {

namespace {
constexpr int kFreezeInterval = 50; // steps
} // namespace

void TimeStepper::initialise(Model& model, const Motion& motion) {
    m_dynamics.attach(model, motion);
    m_ready = false;
}

bool TimeStepper::start(const Motion& motion) {
    if (m_y == nullptr || m_y->map().size() != m_dynamics.size()) {
        m_y = std::make_unique<sundials::StateVector>(m_dynamics.size(), m_context);
    }
    auto y = m_y->map();
    m_dynamics.pack(motion, y);
    m_scaledTime = 0;
    m_untilFreeze = kFreezeInterval;
    create(m_y->get());
    m_ready = true;
    return true;
}

StepReport TimeStepper::step(Motion& motion, const Interrupt& interrupt) {
    StepReport report;
    m_interrupt = interrupt;
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
    m_interrupt = Interrupt();
    if (sundials::meaningOf(m_package, flag) != sundials::Meaning::Fine) {
        m_ready = false;
        report.outcome = interrupt.wanted() ? StepReport::Outcome::Cancelled : StepReport::Outcome::Failed;
        report.note = sundials::nameOf(m_package, flag);
        return report;
    }
    const Vector before = motion.positions;
    m_dynamics.unpack(m_y->map(), motion);
    motion.time += (m_scaledTime - begin) / m_dynamics.frequency();
    return m_dynamics.report(motion, before, lastStep());
}

} // namespace knittsim::physics
