#pragma once

#include "core/physics/rank_one.h"

#include <vector>

namespace knittsim::physics {

/// Three neighbours along one yarn.
struct Bend {
    Entry before = 0;
    Entry middle = 0;
    Entry after = 0;
    double stiffness = 0; ///< C_b, uJ per square radian
};

/// Bend energy C_b (w - 180 deg)^2 with w the angle at the middle point, in radians: equation 6.
/// Gauss-Newton Hessian. Straight yarn and folded yarn (w = 0) have no direction to turn to: no force there.
class BendTerm final : public EnergyTerm {
public:
    explicit BendTerm(std::vector<Bend> places) : m_places(std::move(places)) {}

    double evaluate(const Vector& x, Vector* gradient) const override;
    void linearise(const Vector& x) override;
    void multiply(const Vector& v, Vector& y) const override { m_hessian.multiply(v, y); }
    void addDiagonal(Eigen::Matrix3Xd& blocks) const override { m_hessian.addDiagonal(blocks); }
    void addBlocks(BlockSink& sink) const override { m_hessian.addBlocks(sink); }

private:
    std::vector<Bend> m_places;
    RankOneHessian m_hessian;
};

} // namespace knittsim::physics
