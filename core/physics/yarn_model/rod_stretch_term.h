#pragma once

#include "core/physics/yarn_model/stencil_hessian.h"

namespace knittsim::physics {

/// Stretch of the yarn: 1/2 (EA/l0) (|e| - l0)^2 for every segment e. Hessian exact but for compressed
/// segments, whose negative part across is left out.
class RodStretchTerm final : public EnergyTerm {
public:
    explicit RodStretchTerm(const YarnChains& chains);

    double evaluate(const Vector& x, Vector* gradient) const override;
    void linearise(const Vector& x) override;
    void multiply(const Vector& v, Vector& y) const override { m_hessian.multiply(v, y); }
    void addDiagonal(Eigen::Matrix3Xd& blocks) const override { m_hessian.addDiagonal(blocks); }
    void addBlocks(BlockSink& sink) const override { m_hessian.addBlocks(sink); }

    /// Tension by segment in the order of the chains, EI/d^2.
    std::vector<double> tensions(const Vector& x) const;

private:
    struct Segment {
        Stencil<2> ends;
        double rest = 0;
        double stiffness = 0; ///< EA/l0
    };

    std::vector<Segment> m_segments;
    StencilHessian<2> m_hessian;
};

} // namespace knittsim::physics
