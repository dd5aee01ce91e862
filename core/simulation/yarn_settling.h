#pragma once

#include "core/geometry/curve_report.h"
#include "core/physics/drag_term.h"
#include "core/physics/yarn_model/load_step.h"
#include "core/physics/yarn_model/strand_witness.h"
#include "core/physics/yarn_model/yarn_growth.h"
#include "core/simulation/surroundings.h"
#include "core/simulation/yarn_picture.h"

#include <memory>
#include <optional>

namespace knittsim::simulation {

/// What a shape of yarns does, or did on its way, that yarns cannot do.
struct YarnAudit {
    int coreOverlaps = 0; ///< pairs of segments nearer than their cores are thick
    double deepestOverlapMm = 0;
    machine::LoopIndex worstLoop = -1; ///< of the nearest strands; -1 when all are far apart
    machine::LoopIndex worstOther = -1;
    /// Loops that were laid wrong: not drawn through those below them before anything moved.
    std::vector<geometry::PullThrough> laidWrong;
    /// Strands that went through each other since, step by step (physics::StrandWitness). With none of
    /// either, the shape is knotted as the fabric is, however it has curled up.
    struct Passage {
        machine::LoopIndex loop = -1;
        machine::LoopIndex other = -1;
    };
    std::vector<Passage> passages;
    /// Of the projection, before anything moved: how many there should be and how many were right.
    std::size_t expectedCrossings = 0;
    std::size_t laidCrossings = 0;
    std::size_t foundCrossings = 0; ///< at rest; fewer where edges have rolled up
    std::size_t foldedLoops = 0;    ///< so folded that the shape alone does not show how they are knotted

    std::size_t passThroughs() const { return laidWrong.size() + passages.size(); }
    bool holds() const { return coreOverlaps == 0 && passThroughs() == 0; }
};

/// Settles a whole fabric in the yarn model, step by step: thin yarns along the machine's curves, drawn in
/// (layYarns), that grow and make room for each other (YarnGrowth), then rods that come to rest. The first
/// course hangs on a comb, the live loops on a stitch holder; both float. First the edges are held, between
/// plates, until the stitches have settled; then the surroundings take over, and friction holds what it can:
/// first at every step anew, then from rest to rest, until the forces are in balance at pressures taken from
/// the shape itself.
/// Where the fabric may curl it is shaken first; a free one is neither held nor rubbed.
///
/// What a person does (another yarn, other surroundings, a pull, a pin) goes on from the present shape, also
/// from one at rest. Steps stay limited, so no strand passes through another then either. One thread at a
/// time.
class YarnSettling {
public:
    struct Options {
        YarnLayout layout{};
        const char* integrator = "implicit";
        double residual = 1e-3; ///< of the forces with which yarns press on each other, or the bent yarn's
        Surroundings surroundings = Surroundings::Flat;
    };

    /// The fabric must outlive it.
    YarnSettling(const fabric::Fabric& fabric, std::span<const yarn::Yarn> yarns, const Options& options);

    /// Why there is nothing to settle; empty when all is well.
    const char* problem() const { return m_problem; }

    enum class Phase { Growing, Settling, Done };
    Phase phase() const { return m_phase; }

    /// Some sweeps or one step. False when it is done, or cancelled.
    bool step(const physics::Interrupt& interrupt);

    /// Another diameter, weight and stiffness: all yarns get as thin as there is room for, grow again, and
    /// the fabric is shaken until it has settled once more. No effect without yarn of that carrier.
    void setYarn(machine::CarrierIndex carrier, const yarn::Yarn& yarn);
    void setSurroundings(Surroundings surroundings);

    /// A spring from the yarn at a bonding point to a place, mm, until release(). Begins to act when the
    /// yarns have grown.
    void drag(fabric::PointIndex point, const Vec3& place);
    void release();
    /// Holds the yarn at a bonding point where it is, or frees it. Likewise.
    void setPinned(fabric::PointIndex point, bool pinned);

    const FabricYarns& yarns() const { return m_yarns; }
    const physics::Vector& shape() const { return m_motion.positions; }
    const physics::YarnRelaxReport& report() const { return m_report; }

    YarnAudit audit() const; ///< of the present shape and the way to it
    geometry::YarnCurves curves() const { return curvesOf(m_yarns, shape()); }
    YarnPicture picture() const;

private:
    /// How the rods come to rest.
    enum class Stage {
        Held,   ///< edges pinned, between plates, no friction
        Shaken, ///< in the surroundings, no friction
        Rubbed, ///< in the surroundings, with friction
    };

    void grow(const physics::Interrupt& interrupt);
    std::vector<char> straighten();
    void coarsen(const std::vector<char>& bent);
    void witness(const physics::Vector& from);
    machine::LoopIndex loopAt(physics::Entry node) const;
    void bringBack();
    void startSettling();
    void build(Stage stage, physics::YarnRelaxation::Start start);
    void addHoldings();
    bool curls() const;
    Stage stageAfter(Stage stage) const;
    void wake();
    bool settle(const physics::Interrupt& interrupt);
    void lagFriction();
    bool balance();
    bool isStill(double share) const;
    physics::Vector pressing() const;
    std::vector<float> tension() const;
    std::vector<float> contactForce() const;
    physics::Entry nodeAt(fabric::PointIndex point) const;

    const fabric::Fabric& m_fabric;
    Options m_options;
    FabricYarns m_yarns;
    const char* m_problem = "";
    Phase m_phase = Phase::Growing;
    int m_sweeps = 0;
    int m_grownSweeps = 0; ///< of them at full thickness
    FabricYarns m_laid;    ///< the first ones
    std::optional<physics::StrandWitness> m_witness;
    std::vector<YarnAudit::Passage> m_passages;
    bool m_dense = true; ///< twice the nodes, until the yarns have some thickness
    physics::Motion m_motion;
    std::optional<physics::YarnGrowth> m_growth;
    physics::Vector m_grown; ///< shape in which comb and stitch holder are rigid
    double m_halfGap = 0;    ///< between the plates, yarns as thick as the thickest was
    Stage m_stage = Stage::Held;
    std::unique_ptr<physics::YarnModel> m_model;
    physics::FrictionTerm* m_friction = nullptr; ///< of the model; null when there is none
    physics::DragTerm* m_pull = nullptr;         ///< of the model
    std::optional<physics::YarnRelaxation> m_relaxation;
    physics::YarnRelaxReport m_report;
    physics::YarnRelaxReport m_earlier; ///< work of the models before the present one
    std::vector<double> m_energies;     ///< by step
    /// Steps to go until friction looks anew at what presses; 0 while it does so at every step.
    int m_untilLag = 0;
    int m_lags = 0;          ///< from rest to rest
    double m_unbalanced = 0; ///< residual at the last one

    struct Pull {
        fabric::PointIndex point = -1;
        Vec3 place = Vec3::Zero(); ///< mm
    };
    std::optional<Pull> m_pulled;
    std::vector<fabric::PointIndex> m_pins;
};

} // namespace knittsim::simulation
