#pragma once

/// Units of the core: length mm, force mN, energy uJ (= mN mm), time s, linear density tex (= g/km).
/// Lengths along a bed may also be given in needle pitches; such names end in `Pitches`.
namespace knittsim::units {

constexpr double kMillimetresPerInch = 25.4;

/// N -> mN
constexpr double fromNewton(double newton) {
    return newton * 1e3;
}

/// N m^2 -> mN mm^2
constexpr double fromNewtonSquareMetre(double value) {
    return value * 1e9;
}

} // namespace knittsim::units
