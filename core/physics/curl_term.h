#pragma once

#include "core/physics/energy_term.h"

#include <array>
#include <vector>

namespace knittsim::physics {

/// The course turns out of the fabric's plane at `middle`: coming from `before`, it goes on to `after` turned
/// by `turn` radians about the wale, which runs from `middle` to `above`. Positive turns go towards t x u
/// with t = middle - before, u = above - middle.
struct Curl {
    Entry before = 0;
    Entry middle = 0;
    Entry after = 0;
    Entry above = 0;
    double restBefore = 1; ///< mm
    double restAfter = 1;  ///< mm
    double restAbove = 1;  ///< mm
    double turn = 0;       ///< rad
    double stiffness = 0;  ///< B, uJ
};

/// Energy 1/2 B |r|^2, r = (after - middle)/restAfter - cos(turn) t/restBefore - sin(turn) (t x
/// u)/(restBefore restAbove). A polynomial of the positions, hence smooth in every shape; Gauss-Newton
/// Hessian (exact where r = 0). Source: K stitches beside a change of face curl with their sides to the back,
/// P stitches to the front (PHYSICS-REFERENCE 3.3, ordinal tests); see stitch_mesh.h for where and how much.
class CurlTerm final : public EnergyTerm {
public:
    explicit CurlTerm(std::vector<Curl> places) : m_places(std::move(places)) {}

    double evaluate(const Vector& x, Vector* gradient) const override;
    void linearise(const Vector& x) override;
    void multiply(const Vector& v, Vector& y) const override;
    void addDiagonal(Eigen::Matrix3Xd& blocks) const override;
    void addBlocks(BlockSink& sink) const override;

private:
    /// d r / d (before, middle, after, above), with the root of B inside.
    using Jacobian = std::array<Matrix3, 4>;

    static Jacobian jacobian(const Curl& c, const Vector& x);
    static Eigen::Vector3d residual(const Curl& c, const Vector& x);
    static std::array<Entry, 4> entries(const Curl& c) { return {c.before, c.middle, c.after, c.above}; }

    std::vector<Curl> m_places;
    std::vector<Jacobian> m_linear;
};

} // namespace knittsim::physics
