#pragma once

#include "core/physics/coarse_space.h"
#include "core/physics/preconditioner.h"

namespace knittsim::physics {

/// Block Jacobi for what happens within a few stitches, patches for the rest; added up, so symmetric and
/// positive definite. Needs some 20 to 40 iterations of conjugate gradients where block Jacobi needs 100 to
/// 400.
class TwoLevel final : public Preconditioner {
public:
    /// The shape does not matter.
    explicit TwoLevel(const Model& model) : m_model(model), m_fine(model) { m_coarse.cut(model); }

    using Preconditioner::build;
    void build(double massFactor) override {
        m_fine.build(massFactor);
        m_coarse.build(m_model, massFactor);
    }

    void apply(const Vector& r, Vector& z) const override {
        m_fine.apply(r, z);
        m_coarse.apply(r, z);
        m_model.mask(z);
    }

private:
    const Model& m_model;
    BlockJacobi m_fine;
    CoarseSpace m_coarse;
};

} // namespace knittsim::physics
