#include "core/physics/spring_law.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace knittsim::physics {

namespace {

/// Shorter than at rest: equation 7 where the paper's pull is used, half of it (a linear spring of that
/// stiffness) otherwise.
SpringValue push(PullLaw law, const Spring& s, double delta) {
    const double c = law == PullLaw::Quartic ? 2 * s.push : s.push;
    return {0.5 * c * delta * delta, c * delta, c};
}

SpringValue power(const Spring& s, int a, double delta) {
    const double below = std::pow(delta, a - 1);
    return {s.pull * below * delta * delta / (a + 1), s.pull * below * delta, a * s.pull * below};
}

SpringValue table(const ForceStrainTable& t, double rest, double delta) {
    if (t.strain.size() < 2) {
        return {};
    }
    const double strain = delta / rest;
    double energy = 0;
    std::size_t i = 1;
    for (; i + 1 < t.strain.size() && strain > t.strain[i]; ++i) {
        energy += 0.5 * (t.force[i] + t.force[i - 1]) * (t.strain[i] - t.strain[i - 1]) * rest;
    }
    const double slope = (t.force[i] - t.force[i - 1]) / (t.strain[i] - t.strain[i - 1]);
    const double past = strain - t.strain[i - 1];
    const double force = t.force[i - 1] + slope * past;
    energy += 0.5 * (force + t.force[i - 1]) * past * rest;
    return {energy, force, slope / rest};
}

} // namespace

SpringValue evaluateSpring(const SpringLaw& law, const Spring& s, double distance) {
    const double delta = distance - s.rest;
    if (law.pull == PullLaw::Power) {
        return power(s, law.exponent, delta);
    }
    if (delta < 0) {
        return push(law.pull, s, delta);
    }
    switch (law.pull) {
    case PullLaw::Quartic: {
        const double square = delta * delta;
        return {s.pull * square * square, 4 * s.pull * square * delta, 12 * s.pull * square};
    }
    case PullLaw::Table:
        return table(law.table, std::max(s.rest, 1e-9), delta);
    case PullLaw::Quadratic:
    case PullLaw::Power:
        break;
    }
    return {0.5 * s.pull * delta * delta, s.pull * delta, s.pull};
}

} // namespace knittsim::physics
