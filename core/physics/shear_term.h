#pragma once

#include "core/physics/rank_one.h"

#include <vector>

namespace knittsim::physics {

/// Two arms that meet at `corner` and want to stand at right angles.
struct Corner {
    Entry corner = 0;
    Entry first = 0;
    Entry second = 0;
    double restFirst = 1;  ///< mm
    double restSecond = 1; ///< mm
    double stiffness = 0;  ///< S, uJ
};

/// A leg stands across the heads and sinkers that it runs into: energy 1/2 S p^2, p = first . second / (rest
/// lengths), the sine of the shear for arms at rest length. Gauss-Newton Hessian (exact where p = 0). S = 12
/// EI / arc: a strand between two guided ends (PHYSICS-REFERENCE 3.5, connectors).
class ShearTerm final : public EnergyTerm {
public:
    explicit ShearTerm(std::vector<Corner> corners) : m_corners(std::move(corners)) {}

    double evaluate(const Vector& x, Vector* gradient) const override;
    void linearise(const Vector& x) override;
    void multiply(const Vector& v, Vector& y) const override { m_hessian.multiply(v, y); }
    void addDiagonal(Eigen::Matrix3Xd& blocks) const override { m_hessian.addDiagonal(blocks); }
    void addBlocks(BlockSink& sink) const override { m_hessian.addBlocks(sink); }

private:
    std::vector<Corner> m_corners;
    RankOneHessian m_hessian;
};

} // namespace knittsim::physics
