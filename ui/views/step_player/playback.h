#pragma once

#include <span>

namespace knittsim::ui {

/// Operations to advance for passed time at a speed; fractions carry over, so that slow speeds are exact.
class Playback {
public:
    /// Operations a second at speed 1.
    static constexpr double kUnit = 5;

    /// Operations a second that the user may choose.
    static std::span<const double> speeds();

    double speed() const { return m_speed; }
    void setSpeed(double operationsPerSecond) { m_speed = operationsPerSecond; }

    /// The next faster or slower of speeds().
    void changeSpeed(int direction);

    /// Whole operations due after `milliseconds` more; never more than a second's worth.
    int advance(double milliseconds);

    /// The next operation is due at once.
    void makeDue() { m_due = 1; }

private:
    double m_speed = 5 * kUnit;
    double m_due = 0;
};

} // namespace knittsim::ui
