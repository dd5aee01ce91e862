#include "core/physics/shear_term.h"

#include <cmath>

namespace knittsim::physics {

namespace {

/// Slopes of the root of S times p.
TwoArms arms(const Corner& c, const Vector& x) {
    const double scale = std::sqrt(c.stiffness) / (c.restFirst * c.restSecond);
    return {c.corner, c.first, c.second, scale * (at(x, c.second) - at(x, c.corner)),
            scale * (at(x, c.first) - at(x, c.corner))};
}

} // namespace

double ShearTerm::evaluate(const Vector& x, Vector* gradient) const {
    double energy = 0;
    for (const Corner& c : m_corners) {
        const TwoArms t = arms(c, x);
        const double p = t.slopeFirst.dot(at(x, c.first) - at(x, c.corner));
        energy += 0.5 * p * p;
        if (gradient != nullptr) {
            at(*gradient, c.first) += p * t.slopeFirst;
            at(*gradient, c.second) += p * t.slopeSecond;
            at(*gradient, c.corner) -= p * (t.slopeFirst + t.slopeSecond);
        }
    }
    return energy;
}

void ShearTerm::linearise(const Vector& x) {
    std::vector<TwoArms>& places = m_hessian.places();
    places.clear();
    places.reserve(m_corners.size());
    for (const Corner& c : m_corners) {
        places.push_back(arms(c, x));
    }
}

} // namespace knittsim::physics
