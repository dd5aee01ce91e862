#pragma once

#include "core/physics/yarn_model/contact_kernel.h"
#include "core/physics/yarn_model/near_places.h"
#include "core/physics/yarn_model/own_stretch.h"
#include "core/physics/yarn_model/skin.h"
#include "core/physics/yarn_model/stencil_hessian.h"

namespace knittsim::physics {

/// Keeps the cores of strands apart: ContactKernel between the core diameter and kReach times that, at the
/// closest points of two segments. It acts only where ContactTerm, which looks at nodes, has let strands come
/// that near between their nodes, and it alone holds yarns apart that are thinner than nodes are spaced.
///
/// Segments side by side have closest points that jump from end to end. So the distance that counts is that
/// of min |p(s) - q(t)|^2 + L ((s - 1/2)^2 + (t - 1/2)^2 - 1/6), L = kSmoothing core^2: smooth in the shape,
/// on average the true one and never off by more than a fifth of a percent of the core. Gauss-Newton Hessian,
/// as if these points stayed where they are.
class HardCoreTerm final : public EnergyTerm {
public:
    static constexpr double kReach = 1.1;
    static constexpr double kStiffness = 100; ///< times that of the soft shell
    static constexpr double kSmoothing = 0.01;
    /// The Hessian counts cores that nearly touch, up to this share beyond kReach, as if they touched: a
    /// step would press them together without knowing.
    static constexpr double kAhead = 0.02;

    explicit HardCoreTerm(const YarnChains& chains);

    /// Share of the true diameters, in (0, 1].
    void setThickness(double share);

    /// What presses on what at x.
    std::vector<Press<4>> presses(const Vector& x) const;

    double evaluate(const Vector& x, Vector* gradient) const override;
    void linearise(const Vector& x) override;
    void multiply(const Vector& v, Vector& y) const override { m_hessian.multiply(v, y); }
    void addDiagonal(Eigen::Matrix3Xd& blocks) const override { m_hessian.addDiagonal(blocks); }
    void addBlocks(BlockSink& sink) const override { m_hessian.addBlocks(sink); }

private:
    struct Segment {
        Place begin;
        Place end;
        double rest = 0;
        double exclusion = 0; ///< yarn within which it does not touch itself
        std::size_t yarn = 0;
    };
    struct Kernel {
        ContactKernel value;
        double smoothing = 0; ///< L
    };
    struct Candidate {
        std::array<Place, 4> places; ///< begin and end of both segments
        std::size_t kernel = 0;
        double weight = 0;
    };
    /// Two segments that touch.
    struct Touch {
        Stencil<4> apart; ///< from the closest point of the first to that of the second
        Eigen::Vector3d direction;
        ContactKernel::Value value; ///< slope and curvature by what `apart` grows
    };

    /// Those that are at most (1 + ahead) times the reach apart, as if just inside it.
    template<class Visit> void forTouches(const Vector& x, double ahead, Visit visit) const;
    void prepare(const Vector& x) const;
    void addCandidate(const NearPair& pair) const;

    OwnStretch m_own;
    std::vector<RodYarn> m_yarns;
    std::vector<Segment> m_segments;
    Entry m_cell;
    double m_thickness = 1;
    double m_reach = 0;            ///< of the thickest yarn
    std::vector<Kernel> m_kernels; ///< by pair of yarns
    StencilHessian<4> m_hessian;

    // A cache: candidates follow the shape that is asked about.
    mutable Skin m_skin;
    mutable std::vector<Candidate> m_candidates;
};

} // namespace knittsim::physics
