#pragma once

#include "core/physics/energy_term.h"

#include <vector>

namespace knittsim::physics {

/// Springs between entries and points in space: a person's pull, 1/2 k |x - target|^2.
class DragTerm final : public EnergyTerm {
public:
    struct Pull {
        Entry entry = 0;
        Eigen::Vector3d target = Eigen::Vector3d::Zero(); ///< mm
        double stiffness = 0;                             ///< k, mN/mm
    };

    std::vector<Pull>& pulls() { return m_pulls; }

    double evaluate(const Vector& x, Vector* gradient) const override;
    void linearise(const Vector& /*x*/) override {}
    void multiply(const Vector& v, Vector& y) const override;
    void addDiagonal(Eigen::Matrix3Xd& blocks) const override;
    void addBlocks(BlockSink& sink) const override;

private:
    std::vector<Pull> m_pulls;
};

} // namespace knittsim::physics
