#pragma once

#include "core/physics/energy_term.h"

namespace knittsim::physics {

/// The fabric lies between two soft plates at z = -h and z = +h: energy 1/2 k (|z| - h)^2 of every entry
/// outside. Flattens what would roll or tilt as a whole and leaves the relief of a rib and the two sides of a
/// tube alone, as the swatches lay that were measured (PHYSICS 2, surroundings). Exact Hessian.
class PlateTerm final : public EnergyTerm {
public:
    /// `halfGap` h mm, `stiffness` k mN/mm.
    PlateTerm(double halfGap, double stiffness) : m_halfGap(halfGap), m_stiffness(stiffness) {}

    double evaluate(const Vector& x, Vector* gradient) const override;
    void linearise(const Vector& x) override;
    void multiply(const Vector& v, Vector& y) const override;
    void addDiagonal(Eigen::Matrix3Xd& blocks) const override;
    void addBlocks(BlockSink& sink) const override;

private:
    double m_halfGap;
    double m_stiffness;
    Vector m_linear; ///< by entry: k outside, 0 between the plates
};

} // namespace knittsim::physics
