#pragma once

#include "core/physics/energy_term.h"

#include <Eigen/Core>

namespace knittsim::physics {

/// What acts on a periodic cell from outside: a force on its width and on its height (positive: pulls it
/// wider, higher), each of which may instead be held at a size by a stiff spring. Energy
/// -f s + 1/2 k (s - size)^2 by side s.
class CellLoadTerm final : public EnergyTerm {
public:
    enum Side { Width, Height };

    explicit CellLoadTerm(Entry cell) : m_cell(cell) {}

    /// A dead load instead of what was there; 0: free.
    void pull(Side side, double force) { m_sides[side] = {force, 0, 0}; }

    /// Held at `size`.
    void hold(Side side, double size, double stiffness) { m_sides[side] = {0, size, stiffness}; }

    /// Force that it applies to a side at x, EI/d^2.
    double force(Side side, const Vector& x) const {
        const Load& load = m_sides[side];
        return load.force - load.stiffness * (at(x, m_cell)[side] - load.size);
    }

    double evaluate(const Vector& x, Vector* gradient) const override {
        double energy = 0;
        for (const Side side : {Width, Height}) {
            const Load& load = m_sides[side];
            const double size = at(x, m_cell)[side];
            energy += 0.5 * load.stiffness * (size - load.size) * (size - load.size) - load.force * size;
            if (gradient != nullptr) {
                at(*gradient, m_cell)[side] -= force(side, x);
            }
        }
        return energy;
    }
    void linearise(const Vector& /*x*/) override {}
    void multiply(const Vector& v, Vector& y) const override {
        at(y, m_cell) += stiffness().cwiseProduct(at(v, m_cell));
    }
    void addDiagonal(Eigen::Matrix3Xd& blocks) const override {
        blocks.middleCols<3>(Eigen::Index{3} * m_cell) += stiffness().asDiagonal();
    }
    void addBlocks(BlockSink& sink) const override { sink.add(m_cell, m_cell, stiffness().asDiagonal()); }

private:
    struct Load {
        double force = 0;
        double size = 0;
        double stiffness = 0;
    };

    Eigen::Vector3d stiffness() const { return {m_sides[Width].stiffness, m_sides[Height].stiffness, 0}; }

    Entry m_cell;
    Load m_sides[2];
};

} // namespace knittsim::physics
