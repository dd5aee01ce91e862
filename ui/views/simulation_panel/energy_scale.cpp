#include "ui/views/simulation_panel/energy_scale.h"

#include <algorithm>
#include <cmath>

namespace knittsim::ui {

SymmetricLogScale::SymmetricLogScale(double low, double high, double decades)
    : m_low(std::min(low, 0.0)), m_high(std::max(high, 0.0)) {
    double largest = std::max(m_high, -m_low);
    if (!(largest > 0) || !std::isfinite(largest)) {
        largest = 1;
        m_low = 0;
        m_high = 1;
    }
    m_linear = largest * std::pow(10.0, -decades);
}

double SymmetricLogScale::warp(double value) const {
    return std::asinh(value / m_linear);
}

double SymmetricLogScale::map(double value) const {
    return (warp(value) - warp(m_low)) / (warp(m_high) - warp(m_low));
}

std::vector<double> SymmetricLogScale::ticks() const {
    std::vector<double> ticks{0};
    const double largest = std::max(m_high, -m_low);
    const int last = static_cast<int>(std::floor(std::log10(largest)));
    const int first = static_cast<int>(std::ceil(std::log10(m_linear)));
    for (int power = first; power <= last; ++power) {
        const double size = std::pow(10.0, power);
        if (size <= m_high) {
            ticks.push_back(size);
        }
        if (-size >= m_low) {
            ticks.push_back(-size);
        }
    }
    std::sort(ticks.begin(), ticks.end());
    return ticks;
}

LogScale::LogScale(double low, double high) {
    const double least = std::max(low, 1e-12);
    m_first = static_cast<int>(std::floor(std::log10(least) + 1e-9));
    m_last = std::max(m_first + 1, static_cast<int>(std::ceil(std::log10(std::max(high, least)) - 1e-9)));
}

double LogScale::map(double value) const {
    const double power = std::log10(std::max(value, 1e-300));
    return std::clamp((power - m_first) / (m_last - m_first), 0.0, 1.0);
}

} // namespace knittsim::ui
