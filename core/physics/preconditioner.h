#pragma once

#include "core/physics/energy_term.h"
#include "core/physics/model.h"

namespace knittsim::physics {

/// Inverse of the 3x3 diagonal blocks D of H + massFactor M for a linearised model: symmetric, positive
/// definite.
class BlockJacobi {
public:
    void build(const Model& model, double massFactor = 0);

    /// z = D^-1 r
    void apply(const Vector& r, Vector& z) const;

    /// 1/2 v . D v
    double halfSquare(const Vector& v) const;

private:
    Eigen::Matrix3Xd m_blocks;
    Eigen::Matrix3Xd m_inverse;
};

} // namespace knittsim::physics
