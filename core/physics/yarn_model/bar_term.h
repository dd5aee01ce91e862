#pragma once

#include "core/physics/energy_term.h"

#include <utility>
#include <vector>

namespace knittsim::physics {

/// Nodes on a rigid bar that floats without turning: springs that keep their places relative to each other,
/// 1/2 k sum |x_i - mean x - (start_i - mean start)|^2. The needles of a stitch holder, the teeth of a comb.
class BarTerm final : public EnergyTerm {
public:
    /// `start`: shape whose places the nodes keep.
    BarTerm(std::vector<Entry> nodes, const Vector& start, double stiffness)
        : m_nodes(std::move(nodes)), m_stiffness(stiffness) {
        const Eigen::Vector3d middle = mean(start);
        for (const Entry e : m_nodes) {
            m_places.push_back(at(start, e) - middle);
        }
    }

    double evaluate(const Vector& x, Vector* gradient) const override {
        const Eigen::Vector3d bar = mean(x);
        double energy = 0;
        for (std::size_t i = 0; i < m_nodes.size(); ++i) {
            const Eigen::Vector3d off = at(x, m_nodes[i]) - bar - m_places[i];
            energy += 0.5 * m_stiffness * off.squaredNorm();
            if (gradient != nullptr) {
                at(*gradient, m_nodes[i]) += m_stiffness * off;
            }
        }
        return energy;
    }
    void linearise(const Vector& /*x*/) override {}
    void multiply(const Vector& v, Vector& y) const override {
        const Eigen::Vector3d bar = mean(v);
        for (const Entry e : m_nodes) {
            at(y, e) += m_stiffness * (at(v, e) - bar);
        }
    }
    void addDiagonal(Eigen::Matrix3Xd& blocks) const override {
        for (const Entry e : m_nodes) {
            blocks.middleCols<3>(Eigen::Index{3} * e) += block(1);
        }
    }
    void addBlocks(BlockSink& sink) const override {
        for (const Entry a : m_nodes) {
            for (const Entry b : m_nodes) {
                sink.add(a, b, block(a == b ? 1 : 0));
            }
        }
    }

private:
    Eigen::Vector3d mean(const Vector& x) const {
        Eigen::Vector3d sum = Eigen::Vector3d::Zero();
        for (const Entry e : m_nodes) {
            sum += at(x, e);
        }
        return sum / static_cast<double>(m_nodes.empty() ? 1 : m_nodes.size());
    }

    /// Of a node with itself (`same` 1) or with another one (0).
    Matrix3 block(double same) const {
        return m_stiffness * (same - 1 / static_cast<double>(m_nodes.size())) * Matrix3::Identity();
    }

    std::vector<Entry> m_nodes;
    std::vector<Eigen::Vector3d> m_places; ///< by node of the bar
    double m_stiffness;
};

} // namespace knittsim::physics
