#include "core/physics/yarn_model/knot_term.h"

#include <algorithm>

namespace knittsim::physics {

namespace {
constexpr double kTiny = 1e-12; // below, a spring has no direction
}

double KnotTerm::evaluate(const Vector& x, Vector* gradient) const {
    double energy = 0;
    for (const Knot& knot : m_knots) {
        const Eigen::Vector3d way = at(x, knot.b) - at(x, knot.a);
        const double distance = way.norm();
        const double excess = distance - knot.length;
        energy += 0.5 * knot.stiffness * excess * excess;
        if (gradient != nullptr && distance > kTiny) {
            const Eigen::Vector3d force = (knot.stiffness * excess / distance) * way;
            at(*gradient, knot.a) -= force;
            at(*gradient, knot.b) += force;
        }
    }
    return energy;
}

void KnotTerm::linearise(const Vector& x) {
    m_hessian.parts().clear();
    for (const Knot& knot : m_knots) {
        const Eigen::Vector3d way = at(x, knot.b) - at(x, knot.a);
        const double distance = way.norm();
        const Eigen::Vector3d n =
            distance > kTiny ? Eigen::Vector3d(way / distance) : Eigen::Vector3d::Zero();
        const double across =
            distance > kTiny ? std::max(0.0, knot.stiffness * (1 - knot.length / distance)) : knot.stiffness;
        m_hessian.parts().push_back(
            {{{Place{knot.a, 0, 0}, Place{knot.b, 0, 0}}, {-1, 1}},
             across * Matrix3::Identity() + (knot.stiffness - across) * n * n.transpose()});
    }
}

} // namespace knittsim::physics
