#pragma once

#include "core/physics/yarn_model/contact_kernel.h"
#include "core/physics/yarn_model/near_places.h"
#include "core/physics/yarn_model/own_stretch.h"
#include "core/physics/yarn_model/skin.h"
#include "core/physics/yarn_model/stencil_hessian.h"

#include <cstdint>

namespace knittsim::physics {

/// Yarn against yarn: the double integral of ContactKernel along all yarns (both orders counted, as
/// published), by the sum over pairs of nodes with the yarn that each node stands for. Nodes are much nearer
/// to each other than the kernel is wide, so the sum is the integral to about a percent, it is smooth where
/// yarns lie side by side, and a pair costs one distance. That no yarn slips between two nodes is for
/// StrandGuard.
///
/// Pairs of one yarn less than 2.1 outer radii apart along the yarn do not count. Candidates come from a grid
/// with a skin, found anew for what has moved by half the skin. Hessian without its negative part
/// across the line between the nodes (Gauss-Newton).
class ContactTerm final : public EnergyTerm {
public:
    explicit ContactTerm(const YarnChains& chains);

    /// Share of the true diameters, in (0, 1]: thin yarns for the start.
    void setThickness(double share);
    double thickness() const { return m_thickness; }

    double evaluate(const Vector& x, Vector* gradient) const override;
    void linearise(const Vector& x) override;
    void multiply(const Vector& v, Vector& y) const override { m_hessian.multiply(v, y); }
    void addDiagonal(Eigen::Matrix3Xd& blocks) const override { m_hessian.addDiagonal(blocks); }
    void addBlocks(BlockSink& sink) const override { m_hessian.addBlocks(sink); }

    /// What presses on what at x.
    std::vector<Press<2>> presses(const Vector& x) const;

    /// For figures: pairs within reach at the last linearisation, and how often candidates were found.
    std::size_t pairCount() const { return m_pairCount; }
    int rebuilds() const { return m_rebuilds; }

private:
    struct Candidate {
        Entry a = 0;
        Place b;
        std::uint32_t kernel = 0;
        double weight = 0; ///< both orders: twice the product of the yarn lengths
    };

    void prepare(const Vector& x) const;
    void addCandidates(const std::vector<NearPair>& pairs) const;
    bool sameStretch(const NearPair& pair) const;
    std::uint32_t kernelOf(int yarnA, int yarnB) const;

    std::vector<RodYarn> m_yarns;
    OwnStretch m_own;
    std::vector<double> m_share; ///< yarn by node
    Entry m_nodeCount;
    Entry m_cell;
    double m_thickness = 1;
    std::vector<ContactKernel> m_kernels; ///< by pair of yarns
    StencilHessian<2> m_hessian;
    std::size_t m_pairCount = 0;

    // Candidates are a cache: they follow the shape that is asked about.
    mutable std::vector<Candidate> m_candidates;
    mutable Skin m_skin;
    mutable int m_rebuilds = 0;
};

} // namespace knittsim::physics
