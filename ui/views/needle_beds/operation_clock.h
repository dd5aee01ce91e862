#pragma once

namespace knittsim::ui {

/// Which moment of which operation is shown. A single step is shown moving, forwards or backwards; a jump, or
/// a step that comes while the one before it has hardly begun, shows just the state.
class OperationClock {
public:
    /// Shorter operations would be a flicker.
    static constexpr double kLeastMs = 80;

    /// `step` operations are carried out now. `durationMs`: of one operation; below kLeastMs nothing moves.
    void showStep(int step, double durationMs);

    /// Goes on for `milliseconds` of passed time, unless it is held or has arrived.
    void advance(double milliseconds);

    void hold(bool on) { m_held = on; }
    bool moving() const { return m_phase != m_end; }
    bool running() const { return moving() && !m_held; }

    int operation() const { return m_operation; }
    double phase() const { return m_phase; }

private:
    void arrive();

    int m_step = 0;
    int m_operation = 0;
    double m_phase = 0;
    double m_end = 0; ///< 0 or 1
    double m_durationMs = 0;
    bool m_held = false;
};

} // namespace knittsim::ui
