#pragma once

#include "core/physics/preconditioner.h"
#include "core/physics/yarn_model/banded_cholesky.h"
#include "core/physics/yarn_model/chains.h"

#include <vector>

namespace knittsim::physics {

class YarnModel;

/// The Hessian of a YarnModel along each yarn: stretch and bending in whole, of contact and all else the
/// diagonal blocks. So every chain is a band of its own and costs linear time; chains run in parallel.
///
/// The cell of a periodic fabric borders all chains. What holds a node in place against others then moves
/// with the cell like a point on it does (x and y in proportion), which leaves wide and high cells soft.
class YarnPreconditioner final : public Metric {
public:
    explicit YarnPreconditioner(const YarnModel& model);

    using Preconditioner::build;
    void build(double massFactor) override;
    void apply(const Vector& r, Vector& z) const override;
    double halfSquare(const Vector& v) const override;

private:
    class Sink;
    using Border = Eigen::Matrix<double, Eigen::Dynamic, 3>;

    void factorise();
    void solveChains(Eigen::Ref<Vector> x) const;
    template<class Work> void forChains(Work work) const;

    const YarnModel& m_model;
    std::vector<BandedCholesky> m_bands; ///< by chain
    std::vector<int> m_chainOf;          ///< by node
    Border m_border;                     ///< nodes by cell
    Border m_solvedBorder;               ///< bands^-1 border
    Matrix3 m_corner = Matrix3::Zero();  ///< cell by cell
    Matrix3 m_schurInverse = Matrix3::Zero();
};

} // namespace knittsim::physics
