#pragma once

#include "core/physics/energy_term.h"

#include <vector>

namespace knittsim::physics {

/// Cholesky factorisation of one chain's symmetric matrix of 3x3 blocks, where a node is coupled with the two
/// nodes before and after it: linear in the nodes. A closed chain is folded (first, last, second, last but
/// one ...) and so becomes a band too.
class BandedCholesky {
public:
    BandedCholesky(Entry nodeCount, bool closed);

    Entry nodeCount() const { return m_nodeCount; }

    void setZero();

    /// Adds a block; of (i, j) and (j, i) both may be given. Nodes farther apart than two are an error.
    void add(Entry i, Entry j, const Matrix3& block);

    /// True when the matrix is positive definite; else the factors are of no use.
    bool factorise();

    /// x := A^-1 x. `x` has 3 numbers by node, in the order of the chain.
    void solve(Eigen::Ref<Vector> x) const;

    /// v . A v, from the factors.
    double square(const Eigen::Ref<const Vector>& v) const;

private:
    double& band(Eigen::Index row, Eigen::Index column) {
        return m_band[static_cast<std::size_t>(row * (m_width + 1) + column - row + m_width)];
    }
    double band(Eigen::Index row, Eigen::Index column) const {
        return m_band[static_cast<std::size_t>(row * (m_width + 1) + column - row + m_width)];
    }
    Eigen::Index place(Entry node) const;
    Vector folded(const Eigen::Ref<const Vector>& v) const;

    Entry m_nodeCount;
    bool m_closed;
    Eigen::Index m_width;       ///< scalars left of the diagonal
    std::vector<double> m_band; ///< row after row, the diagonal last
};

} // namespace knittsim::physics
