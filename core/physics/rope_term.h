#pragma once

#include "core/physics/energy_term.h"

#include <cstddef>
#include <vector>

namespace knittsim::physics {

/// A float that slides where it passes other strands: it pulls when the way through its entries is longer
/// than its rest length and hangs slack otherwise. Energy 1/2 k (way - rest)^2 for way > rest. The Hessian is
/// exact but for pieces shorter than the excess, where the part across is bounded by k.
class RopeTerm final : public EnergyTerm {
public:
    /// `way`: at least two entries; `stiffness` k mN/mm, `rest` mm.
    void add(const std::vector<Entry>& way, double rest, double stiffness);

    std::size_t size() const { return m_ropes.size(); }

    /// Force in the yarn, mN, the same all along the rope.
    double tension(const Vector& x, std::size_t rope) const;

    double evaluate(const Vector& x, Vector* gradient) const override;
    void linearise(const Vector& x) override;
    void multiply(const Vector& v, Vector& y) const override;
    void addDiagonal(Eigen::Matrix3Xd& blocks) const override;
    void addBlocks(BlockSink& sink) const override;

private:
    struct Rope {
        std::size_t first = 0; ///< into m_way
        std::size_t count = 0;
        double rest = 0;
        double stiffness = 0;
    };
    /// Of one rope under tension: H = slope slope^T, plus for each of its pieces the part across the piece.
    struct Taut {
        std::size_t rope = 0;
        std::vector<Eigen::Vector3d> slope; ///< by entry of the way, with the root of k inside
        std::vector<Matrix3> across;        ///< by piece
    };

    double excess(const Vector& x, const Rope& rope) const;
    Entry entry(const Rope& rope, std::size_t i) const { return m_way[rope.first + i]; }

    std::vector<Rope> m_ropes;
    std::vector<Entry> m_way;
    std::vector<Taut> m_taut;
};

} // namespace knittsim::physics
