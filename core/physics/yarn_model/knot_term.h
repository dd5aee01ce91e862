#pragma once

#include "core/physics/yarn_model/stencil_hessian.h"

namespace knittsim::physics {

/// Knots: springs that hold two nodes at a distance, 1/2 k (|x_b - x_a| - length)^2. Hessian exact but for
/// compressed springs, whose negative part across is left out.
class KnotTerm final : public EnergyTerm {
public:
    struct Knot {
        Entry a = 0;
        Entry b = 0;
        double length = 0;
        double stiffness = 0;
    };

    explicit KnotTerm(std::vector<Knot> knots) : m_knots(std::move(knots)), m_hessian(-1) {}

    double evaluate(const Vector& x, Vector* gradient) const override;
    void linearise(const Vector& x) override;
    void multiply(const Vector& v, Vector& y) const override { m_hessian.multiply(v, y); }
    void addDiagonal(Eigen::Matrix3Xd& blocks) const override { m_hessian.addDiagonal(blocks); }
    void addBlocks(BlockSink& sink) const override { m_hessian.addBlocks(sink); }

private:
    std::vector<Knot> m_knots;
    StencilHessian<2> m_hessian;
};

} // namespace knittsim::physics
