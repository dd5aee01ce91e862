#pragma once

#include "core/physics/energy_term.h"

namespace knittsim::physics {

class Model;

/// Approximate inverse of H + massFactor M for a linearised system: symmetric, positive definite, and it
/// leaves pinned entries where they are.
class Preconditioner {
public:
    virtual ~Preconditioner() = default;

    /// Once after each linearisation; massFactor in 1/s^2.
    virtual void build(double massFactor) = 0;
    void build() { build(0); }

    /// z = P^-1 r
    virtual void apply(const Vector& r, Vector& z) const = 0;
};

/// A preconditioner whose own matrix P is at hand: a metric.
class Metric : public Preconditioner {
public:
    /// 1/2 v . P v
    virtual double halfSquare(const Vector& v) const = 0;
};

/// The 3x3 diagonal blocks of H + massFactor M.
class BlockJacobi final : public Metric {
public:
    explicit BlockJacobi(const Model& model) : m_model(model) {}

    using Preconditioner::build;
    void build(double massFactor) override;
    void apply(const Vector& r, Vector& z) const override;
    double halfSquare(const Vector& v) const override;

private:
    const Model& m_model;
    Eigen::Matrix3Xd m_blocks;
    Eigen::Matrix3Xd m_inverse;
};

} // namespace knittsim::physics
