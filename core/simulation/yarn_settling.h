#pragma once

#include "core/geometry/curve_report.h"
#include "core/physics/yarn_model/load_step.h"
#include "core/physics/yarn_model/yarn_growth.h"
#include "core/simulation/fabric_yarns.h"

#include <memory>
#include <optional>

namespace knittsim::simulation {

/// What a shape of yarns does that yarns cannot do.
struct YarnAudit {
    int coreOverlaps = 0; ///< pairs of segments nearer than their cores are thick
    double deepestOverlapMm = 0;
    machine::LoopIndex worstLoop = -1; ///< of the nearest strands; -1 when all are far apart
    machine::LoopIndex worstOther = -1;
    /// Loops of which the shape does not show that they are drawn through those below. No step lets strands
    /// pass each other, so in a fabric that curls up this is doubt rather than proof.
    std::vector<geometry::PullThrough> pullThroughs;
    /// Nodes that had to be left out before the way was free: there, and only there, a strand may have passed
    /// another.
    int cutCorners = 0;
    std::size_t expectedCrossings = 0; ///< of the projection, while the fabric lies flat
    std::size_t foundCrossings = 0;

    bool holds() const { return coreOverlaps == 0 && cutCorners == 0 && pullThroughs.empty(); }
};

/// Settles a whole fabric in the yarn model, step by step: thin yarns along the machine's curves, drawn in
/// (layYarns), that grow and make room for each other (YarnGrowth), then rods that come to rest. The first
/// course hangs on a comb, the live loops on a stitch holder; both float. On a table the edges are held until
/// the stitches have settled; then friction holds what it can. A fabric that may curl is shaken: it has no
/// friction. One thread at a time.
class YarnSettling {
public:
    struct Options {
        YarnLayout layout{};
        const char* integrator = "implicit";
        double residual = 1e-3;
        /// Between two soft plates, as far apart as the relief of the fabric with stitches of one bed,
        /// farther where it has stitches of both; else it may curl.
        bool onTable = true;
    };

    YarnSettling(const fabric::Fabric& fabric, std::span<const yarn::Yarn> yarns, const Options& options);

    /// Why there is nothing to settle; empty when all is well.
    const char* problem() const { return m_problem; }

    enum class Phase { Growing, Settling, Done };
    Phase phase() const { return m_phase; }

    /// Some sweeps or one step. False when it is done, or cancelled.
    bool step(const physics::Interrupt& interrupt);

    const FabricYarns& yarns() const { return m_yarns; }
    const physics::Vector& shape() const { return m_motion.positions; }
    const physics::YarnRelaxReport& report() const { return m_report; }

    YarnAudit audit() const; ///< of the present shape
    geometry::YarnCurves curves() const { return curvesOf(m_yarns, shape()); }

private:
    void grow();
    int straighten();
    void coarsen();
    void startSettling();
    bool settle(const physics::Interrupt& interrupt);
    void hold(bool held);
    void letGo();
    bool isStill(double share) const;

    const fabric::Fabric& m_fabric;
    Options m_options;
    FabricYarns m_yarns;
    const char* m_problem = "";
    Phase m_phase = Phase::Growing;
    int m_sweeps = 0;
    int m_grownSweeps = 0; ///< of them at full thickness
    int m_cutCorners = 0;
    bool m_dense = true; ///< twice the nodes, until the yarns have some thickness
    physics::Motion m_motion;
    std::optional<physics::YarnGrowth> m_growth;
    std::unique_ptr<physics::YarnModel> m_model;
    physics::FrictionTerm* m_friction = nullptr; ///< of the model; null when there is none
    bool m_held = false;                         ///< edges stay where the repeat's spacings put them
    std::optional<physics::YarnRelaxation> m_relaxation;
    physics::YarnRelaxReport m_report;
    std::vector<double> m_energies; ///< by step
};

} // namespace knittsim::simulation
