#pragma once

#include "core/physics/energy_term.h"

#include <vector>

namespace knittsim::physics {

/// Weight: energy -f . x by entry.
class GravityTerm final : public EnergyTerm {
public:
    /// Force on every entry along `direction`; `weights` by entry, 0 for those without.
    GravityTerm(const std::vector<double>& weights, const Eigen::Vector3d& direction)
        : m_force(Vector::Zero(3 * static_cast<Eigen::Index>(weights.size()))) {
        for (std::size_t e = 0; e < weights.size(); ++e) {
            at(m_force, static_cast<Entry>(e)) = weights[e] * direction;
        }
    }

    double evaluate(const Vector& x, Vector* gradient) const override {
        if (gradient != nullptr) {
            *gradient -= m_force;
        }
        return -m_force.dot(x);
    }
    void linearise(const Vector& /*x*/) override {}
    void multiply(const Vector& /*v*/, Vector& /*y*/) const override {}
    void addDiagonal(Eigen::Matrix3Xd& /*blocks*/) const override {}
    void addBlocks(BlockSink& /*sink*/) const override {}

private:
    Vector m_force;
};

} // namespace knittsim::physics
