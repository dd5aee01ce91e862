#include "core/physics/bend_term.h"

#include <Eigen/Geometry>

#include <cmath>

namespace knittsim::physics {

namespace {

constexpr double kTiny = 1e-9;

/// The turn 180 deg - w and its slopes.
struct Turn {
    double angle = 0;
    TwoArms arms;
};

Turn turn(const Bend& b, const Vector& x) {
    Turn result{0, {b.middle, b.before, b.after}};
    const Eigen::Vector3d e = at(x, b.middle) - at(x, b.before);
    const Eigen::Vector3d f = at(x, b.after) - at(x, b.middle);
    const double eLength = e.norm();
    const double fLength = f.norm();
    if (eLength < kTiny || fLength < kTiny) {
        return result;
    }
    const Eigen::Vector3d eUnit = e / eLength;
    const Eigen::Vector3d fUnit = f / fLength;
    const double cosine = eUnit.dot(fUnit);
    const double sine = eUnit.cross(fUnit).norm();
    result.angle = std::atan2(sine, cosine);
    if (sine > kTiny) {
        result.arms.slopeFirst = (fUnit - cosine * eUnit) / (sine * eLength);
        result.arms.slopeSecond = (cosine * fUnit - eUnit) / (sine * fLength);
    }
    return result;
}

} // namespace

double BendTerm::evaluate(const Vector& x, Vector* gradient) const {
    double energy = 0;
    for (const Bend& b : m_places) {
        const Turn t = turn(b, x);
        energy += b.stiffness * t.angle * t.angle;
        if (gradient != nullptr) {
            const double slope = 2 * b.stiffness * t.angle;
            at(*gradient, b.before) += slope * t.arms.slopeFirst;
            at(*gradient, b.after) += slope * t.arms.slopeSecond;
            at(*gradient, b.middle) -= slope * (t.arms.slopeFirst + t.arms.slopeSecond);
        }
    }
    return energy;
}

void BendTerm::linearise(const Vector& x) {
    std::vector<TwoArms>& places = m_hessian.places();
    places.clear();
    places.reserve(m_places.size());
    for (const Bend& b : m_places) {
        TwoArms arms = turn(b, x).arms;
        const double root = std::sqrt(2 * b.stiffness);
        arms.slopeFirst *= root;
        arms.slopeSecond *= root;
        places.push_back(arms);
    }
}

} // namespace knittsim::physics
