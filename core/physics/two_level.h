#pragma once

#include "core/physics/coarse_space.h"
#include "core/physics/preconditioner.h"

namespace knittsim::physics {

/// Block Jacobi for what happens within a few stitches, patches for the rest; added up, so symmetric and
/// positive definite. Needs some 20 to 40 iterations of conjugate gradients where block Jacobi needs 100 to
/// 400.
class TwoLevel {
public:
    /// Once per model; the shape does not matter.
    void prepare(const Model& model) { m_coarse.cut(model); }

    /// For H + massFactor M, H the model's linearised Hessian, M its masses (massFactor in 1/s^2).
    void build(const Model& model, double massFactor = 0) {
        m_model = &model;
        m_fine.build(model, massFactor);
        m_coarse.build(model, massFactor);
    }

    void apply(const Vector& r, Vector& z) const {
        m_fine.apply(r, z);
        m_coarse.apply(r, z);
        m_model->mask(z);
    }

private:
    const Model* m_model = nullptr;
    BlockJacobi m_fine;
    CoarseSpace m_coarse;
};

} // namespace knittsim::physics
