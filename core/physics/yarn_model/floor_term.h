#pragma once

#include "core/physics/energy_term.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace knittsim::physics {

/// A plane below that yarn rests on with its surface: 1/2 k (floor + radius - z)^2 of every entry whose
/// middle is nearer to it than its radius. Exact Hessian.
class FloorTerm final : public EnergyTerm {
public:
    /// `radii` by entry, 0 for those without a body; `height` of the plane along z.
    FloorTerm(double height, std::vector<double> radii, double stiffness)
        : m_height(height), m_radii(std::move(radii)), m_stiffness(stiffness), m_touches(m_radii.size(), 0) {}

    double evaluate(const Vector& x, Vector* gradient) const override {
        double energy = 0;
        for (std::size_t e = 0; e < m_radii.size(); ++e) {
            const double depth = depthOf(x, e);
            energy += 0.5 * m_stiffness * depth * depth;
            if (gradient != nullptr) {
                (*gradient)[axis(e)] -= m_stiffness * depth;
            }
        }
        return energy;
    }
    void linearise(const Vector& x) override {
        for (std::size_t e = 0; e < m_radii.size(); ++e) {
            m_touches[e] = depthOf(x, e) > 0 ? 1 : 0;
        }
    }
    void multiply(const Vector& v, Vector& y) const override {
        for (std::size_t e = 0; e < m_touches.size(); ++e) {
            y[axis(e)] += m_stiffness * m_touches[e] * v[axis(e)];
        }
    }
    void addDiagonal(Eigen::Matrix3Xd& blocks) const override {
        for (std::size_t e = 0; e < m_touches.size(); ++e) {
            blocks(2, axis(e)) += m_stiffness * m_touches[e];
        }
    }
    void addBlocks(BlockSink& sink) const override {
        for (std::size_t e = 0; e < m_touches.size(); ++e) {
            if (m_touches[e] > 0) {
                Matrix3 block = Matrix3::Zero();
                block(2, 2) = m_stiffness;
                sink.add(static_cast<Entry>(e), static_cast<Entry>(e), block);
            }
        }
    }

private:
    static Eigen::Index axis(std::size_t entry) { return 3 * static_cast<Eigen::Index>(entry) + 2; }
    double depthOf(const Vector& x, std::size_t e) const {
        return std::max(0.0, m_height + m_radii[e] - x[axis(e)]);
    }

    double m_height;
    std::vector<double> m_radii;
    double m_stiffness;
    std::vector<double> m_touches; ///< 1 below the plane
};

} // namespace knittsim::physics
