#pragma once

#include <Eigen/Core>

namespace knittsim::physics {

/// 3 numbers per entry of the bonding point table, entry after entry (positions mm, forces mN, velocities
/// mm/s).
using Vector = Eigen::VectorXd;
using Matrix3 = Eigen::Matrix3d;
using Entry = int; ///< row of the bonding point table

inline auto at(Vector& v, Entry e) {
    return v.segment<3>(Eigen::Index{3} * e);
}
inline auto at(const Vector& v, Entry e) {
    return v.segment<3>(Eigen::Index{3} * e);
}

/// Takes the 3x3 blocks of a Hessian; blocks of one place add up. Both (a, b) and (b, a) are given.
class BlockSink {
public:
    virtual ~BlockSink() = default;
    virtual void add(Entry row, Entry column, const Matrix3& block) = 0;
};

/// One kind of energy, summed over all its places. Energies in uJ = mN mm.
///
/// `linearise` remembers a positive semi-definite Hessian at a shape (mN/mm): the exact one, or the exact one
/// without its negative part, or Gauss-Newton where the header of the term says so. `multiply`, `addDiagonal`
/// and `addBlocks` give that same matrix.
class EnergyTerm {
public:
    virtual ~EnergyTerm() = default;

    /// Energy at x; adds its gradient (minus the force) to `gradient` unless that is null.
    virtual double evaluate(const Vector& x, Vector* gradient) const = 0;

    virtual void linearise(const Vector& x) = 0;

    /// y += H v
    virtual void multiply(const Vector& v, Vector& y) const = 0;

    /// Adds the 3x3 blocks on the diagonal; `blocks` is 3 x 3n.
    virtual void addDiagonal(Eigen::Matrix3Xd& blocks) const = 0;

    virtual void addBlocks(BlockSink& sink) const = 0;
};

} // namespace knittsim::physics
