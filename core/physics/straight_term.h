#pragma once

#include "core/physics/energy_term.h"

#include <vector>

namespace knittsim::physics {

/// `before`, `middle` and `after` want to lie on a line, with the lengths in the ratio of the rest lengths:
/// energy 1/2 B |r|^2, r = (after - middle)/restAfter - (middle - before)/restBefore.
struct Straight {
    Entry before = 0;
    Entry middle = 0;
    Entry after = 0;
    double restBefore = 1; ///< mm
    double restAfter = 1;  ///< mm
    double stiffness = 0;  ///< B, uJ
};

/// Bending of strands at crossings and of the fabric across wales and courses. For small turns r is the turn
/// in radians, so B is EI over a length. Exact, constant Hessian; no singular shapes.
class StraightTerm final : public EnergyTerm {
public:
    explicit StraightTerm(const std::vector<Straight>& places);

    std::size_t size() const { return m_places.size(); }

    double evaluate(const Vector& x, Vector* gradient) const override;
    void linearise(const Vector& x) override;
    void multiply(const Vector& v, Vector& y) const override;
    void addDiagonal(Eigen::Matrix3Xd& blocks) const override;
    void addBlocks(BlockSink& sink) const override;

private:
    /// r = weight[0] x[entry[0]] + weight[1] x[entry[1]] + weight[2] x[entry[2]], with the root of B inside.
    struct Place {
        Entry entry[3];
        double weight[3];
    };

    std::vector<Place> m_places;
};

} // namespace knittsim::physics
