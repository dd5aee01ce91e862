#pragma once

#include "core/physics/yarn_model/stencil_hessian.h"

namespace knittsim::physics {

/// Bending of the yarn, by inner node: 1/2 (EI/l) (|b| - l k0)^2 with the turn b = (x+ - x) / l+ - (x - x-) /
/// l- and l the mean of l- and l+. With equal lengths and k0 = 0 this is 1/2 (EI/l^3) |x- - 2x + x+|^2, whose
/// Hessian is constant.
///
/// The rest curvature k0 is a number, not a vector: torsion is free, so a yarn with set turns about its own
/// axis until its bend points where the shape wants it. Hessian exact but for nodes bent less than k0, whose
/// negative part across is left out.
class RodBendTerm final : public EnergyTerm {
public:
    explicit RodBendTerm(const YarnChains& chains);

    double evaluate(const Vector& x, Vector* gradient) const override;
    void linearise(const Vector& x) override;
    void multiply(const Vector& v, Vector& y) const override { m_hessian.multiply(v, y); }
    void addDiagonal(Eigen::Matrix3Xd& blocks) const override { m_hessian.addDiagonal(blocks); }
    void addBlocks(BlockSink& sink) const override { m_hessian.addBlocks(sink); }

    /// |b| / l by node, 0 at the ends of open chains.
    std::vector<double> curvatures(const Vector& x) const;

    /// Every yarn keeps its RodYarn::set of the curvature that it has at x as rest curvature.
    void takeSet(const Vector& x);

    /// k0 by node.
    std::vector<double> restCurvatures() const;

private:
    struct Bend {
        Stencil<3> turn;
        double length = 0;    ///< l
        double stiffness = 0; ///< EI / l
        double restTurn = 0;  ///< l k0
        double set = 0;       ///< of its yarn
    };

    std::size_t m_nodeCount;
    std::vector<Bend> m_bends;
    StencilHessian<3> m_hessian;
};

} // namespace knittsim::physics
