#pragma once

#include "core/physics/model.h"

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <vector>

namespace knittsim::physics {

/// Patches of the fabric that move as one: what block Jacobi alone would need hundreds of sweeps for. The
/// Hessian for these motions is summed up exactly and factorised.
class CoarseSpace {
public:
    /// Cuts the model's layout into patches of about `entriesAcross` x `entriesAcross` entries, front and
    /// rear bed apart, larger ones where there would be more than kMostPatches.
    void cut(const Model& model, int entriesAcross = 6);

    /// Takes H + massFactor M of a linearised model. False when it cannot be factorised; then apply does
    /// nothing.
    bool build(const Model& model, double massFactor = 0);

    /// z += P A^-1 P^T r, P the patches' motions.
    void apply(const Vector& r, Vector& z) const;

    int patchCount() const { return m_patchCount; }

    /// Keeps one factorisation below about 50 ms, so that a cancel is heard in time.
    static constexpr int kMostPatches = 1200;

private:
    std::vector<int> m_patch; ///< by entry
    int m_patchCount = 0;
    bool m_usable = false;
    Eigen::SparseMatrix<double> m_matrix; ///< the last one, whose pattern m_solver knows
    Eigen::SimplicialLLT<Eigen::SparseMatrix<double>> m_solver;
};

} // namespace knittsim::physics
