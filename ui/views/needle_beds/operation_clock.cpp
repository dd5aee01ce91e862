#include "ui/views/needle_beds/operation_clock.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace knittsim::ui {

namespace {

constexpr double kHardlyBegun = 0.25;

} // namespace

void OperationClock::showStep(int step, double durationMs) {
    const int before = std::exchange(m_step, step);
    const bool rushed = running() && std::abs(m_end - m_phase) > 1 - kHardlyBegun;
    const bool single = std::abs(step - before) == 1 && durationMs >= kLeastMs;
    m_held = false;
    m_durationMs = durationMs;
    const double end = step > before ? 1 : 0;
    const int operation = std::min(step, before);
    const bool turns = m_operation == operation && moving() && m_end != end; // back on the same way
    if (!single || (rushed && !turns)) {
        arrive();
        return;
    }
    if (!turns) {
        m_phase = 1 - end;
    }
    m_operation = operation;
    m_end = end;
}

void OperationClock::advance(double milliseconds) {
    if (!running()) {
        return;
    }
    const double way = milliseconds / m_durationMs;
    m_phase = m_end > 0 ? std::min(1.0, m_phase + way) : std::max(0.0, m_phase - way);
    if (!moving()) {
        arrive();
    }
}

/// At rest the operation carried out last is named, also after stepping back.
void OperationClock::arrive() {
    m_operation = std::max(0, m_step - 1);
    m_phase = m_end = m_step > 0 ? 1 : 0;
}

} // namespace knittsim::ui
