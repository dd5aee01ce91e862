#pragma once

#include "core/physics/energy_term.h"

#include <vector>

namespace knittsim::physics {

/// A scalar p of three entries, of which only the two arms first - middle and second - middle matter.
struct TwoArms {
    Entry middle = 0;
    Entry first = 0;
    Entry second = 0;
    Eigen::Vector3d slopeFirst = Eigen::Vector3d::Zero();  ///< d p / d first
    Eigen::Vector3d slopeSecond = Eigen::Vector3d::Zero(); ///< d p / d second
};

/// Sum of (grad p)(grad p)^T: the Gauss-Newton Hessian of a sum of 1/2 p^2.
class RankOneHessian {
public:
    std::vector<TwoArms>& places() { return m_places; }

    void multiply(const Vector& v, Vector& y) const;
    void addDiagonal(Eigen::Matrix3Xd& blocks) const;
    void addBlocks(BlockSink& sink) const;

private:
    std::vector<TwoArms> m_places;
};

} // namespace knittsim::physics
