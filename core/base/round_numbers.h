#pragma once

#include <cmath>

namespace knittsim {

/// The smallest of 1, 2 and 5 times a power of ten that is not below a positive value: steps of scales.
inline double roundUp(double value) {
    const double power = std::pow(10.0, std::floor(std::log10(value)));
    for (const double step : {1.0, 2.0, 5.0}) {
        if (value <= 1.0001 * step * power) {
            return step * power;
        }
    }
    return 10 * power;
}

} // namespace knittsim
