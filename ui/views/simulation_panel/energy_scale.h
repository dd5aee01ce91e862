#pragma once

#include <vector>

namespace knittsim::ui {

/// An axis for values of both signs over many decades: linear about zero, logarithmic beyond.
class SymmetricLogScale {
public:
    /// `low` and `high` are the extremes shown; `decades` below the largest size the axis turns linear.
    SymmetricLogScale(double low, double high, double decades = 4);

    /// 0 at `low`, 1 at `high`.
    double map(double value) const;

    /// Zero and powers of ten of both signs within the axis.
    std::vector<double> ticks() const;

private:
    double warp(double value) const;

    double m_low;
    double m_high;
    double m_linear;
};

/// A logarithmic axis from whole power to whole power of ten.
class LogScale {
public:
    LogScale(double low, double high);

    double map(double value) const; ///< clamped to 0..1
    int firstPower() const { return m_first; }
    int lastPower() const { return m_last; }

private:
    int m_first;
    int m_last;
};

} // namespace knittsim::ui
