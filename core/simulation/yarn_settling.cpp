#include "core/simulation/yarn_settling.h"

#include "core/physics/plate_term.h"
#include "core/physics/yarn_model/bar_term.h"
#include "core/physics/yarn_model/knot_term.h"

#include <algorithm>
#include <cmath>

namespace knittsim::simulation {

namespace {

using physics::Entry;
using physics::StopRule;

constexpr int kSweepsAtOnce = 10;
constexpr int kMostSweeps = 200;
constexpr int kMostGrownSweeps = 150; ///< at full thickness; the rods make the rest of the room
constexpr double kCoarseFrom = 0.5;   ///< thickness
constexpr int kStraightening = 12;
constexpr double kStraight = 1e-6;   ///< d
constexpr double kRoomEnough = 1.03; ///< distance over core diameter
constexpr double kHolding = 1;       ///< stiffness of comb, holder and knots against that of a segment
constexpr double kPlates = 0.1;
constexpr double kTwoFacedHalf = 2.4; ///< diameters: a rib is 3.4 to 4.8 thick (PHYSICS-REFERENCE 3.3)
/// A fabric whose energy falls by less in so many steps is at rest for all that one can measure of it: what
/// still moves are loose ends.
constexpr double kEnergyAtRest = 1e-3;
constexpr double kEnergyHeld = 1e-2;
constexpr std::size_t kStepsAtRest = 8;

std::vector<Entry> endsOf(const physics::YarnChains& chains) {
    std::vector<Entry> ends;
    for (const physics::Chain& chain : chains.chains) {
        ends.insert(ends.end(), {chain.first, chain.first + chain.count - 1});
    }
    return ends;
}

/// Stitches of both beds: the fabric finds its own thickness.
bool isTwoFaced(const fabric::Fabric& f) {
    const auto isFront = [](const machine::Loop& loop) { return machine::isFront(loop.needle.bed); };
    const bool any = std::ranges::any_of(f.made.loops, isFront);
    return any && !std::ranges::all_of(f.made.loops, isFront);
}

/// Puts the fabric in the middle of z = 0. Returns half of its relief.
double centreRelief(physics::Vector& x) {
    auto z = Eigen::Map<Eigen::Matrix3Xd>(x.data(), 3, x.size() / 3).row(2);
    const double low = z.minCoeff();
    const double high = z.maxCoeff();
    z.array() -= 0.5 * (low + high);
    return 0.5 * (high - low);
}

} // namespace

YarnSettling::YarnSettling(const fabric::Fabric& fabric, std::span<const yarn::Yarn> yarns,
                           const Options& options)
    : m_fabric(fabric), m_options(options) {
    // Thin yarns that lie close need more nodes than thick ones.
    YarnLayout dense = options.layout;
    dense.nodesPerLoop *= 2;
    m_yarns = layYarns(fabric, yarns, dense);
    m_problem =
        m_yarns.chains.nodeCount() == 0 ? "there is no yarn in this fabric" : m_yarns.chains.problem();
    if (*m_problem != '\0') {
        m_phase = Phase::Done;
        return;
    }
    m_motion.positions = m_yarns.chains.start();
    m_motion.velocities.setZero(m_motion.positions.size());
    m_growth.emplace(m_yarns.chains, endsOf(m_yarns.chains));
}

bool YarnSettling::step(const physics::Interrupt& interrupt) {
    if (interrupt.wanted() || m_phase == Phase::Done) {
        return false;
    }
    if (m_phase == Phase::Growing) {
        grow();
        return true;
    }
    return settle(interrupt);
}

void YarnSettling::grow() {
    for (int i = 0; i < kSweepsAtOnce; ++i) {
        m_growth->sweep(m_motion.positions);
    }
    m_sweeps += kSweepsAtOnce;
    if (m_dense) {
        if (m_growth->thickness() >= kCoarseFrom) {
            m_cutCorners = straighten();
            if (m_cutCorners == 0 || m_sweeps >= kMostSweeps) {
                coarsen();
            }
        }
        return;
    }
    m_grownSweeps += m_growth->thickness() >= 1 ? kSweepsAtOnce : 0;
    if (m_grownSweeps > 0 && (m_growth->room() > kRoomEnough || m_grownSweeps >= kMostGrownSweeps)) {
        startSettling();
    }
}

/// Every second node goes to the middle of its neighbours as far as no strand is in the way. Returns how many
/// do not get there.
int YarnSettling::straighten() {
    physics::Vector& x = m_motion.positions;
    physics::StrandGuard guard(m_yarns.chains);
    for (int round = 0; round < kStraightening; ++round) {
        physics::Vector move = physics::Vector::Zero(x.size());
        int left = 0;
        for (const physics::Chain& chain : m_yarns.chains.chains) {
            for (Entry e = chain.first + 1; e < chain.first + chain.count - 1; e += 2) {
                const Eigen::Vector3d middle = 0.5 * (physics::at(x, e - 1) + physics::at(x, e + 1));
                physics::at(move, e) = middle - physics::at(x, e);
                left += physics::at(move, e).norm() > kStraight ? 1 : 0;
            }
        }
        if (left == 0 || round + 1 == kStraightening) {
            return left;
        }
        std::vector<double> share(static_cast<std::size_t>(m_yarns.chains.nodeCount()), 1);
        guard.lowerShares(x, move, share);
        for (std::size_t e = 0; e < share.size(); ++e) {
            physics::at(move, static_cast<Entry>(e)) *= share[e];
        }
        x += guard.allowed(x, move) * move;
    }
    return 0;
}

void YarnSettling::coarsen() {
    const double thickness = m_growth->thickness();
    m_yarns = withHalfTheNodes(m_fabric, m_yarns, m_motion.positions);
    m_motion.positions = m_yarns.chains.start();
    m_motion.velocities.setZero(m_motion.positions.size());
    m_growth.emplace(m_yarns.chains, endsOf(m_yarns.chains), thickness);
    m_dense = false;
}

void YarnSettling::startSettling() {
    m_growth.reset();
    m_model = std::make_unique<physics::YarnModel>(m_yarns.chains);
    physics::Vector& x = m_motion.positions;
    const double relief = centreRelief(x);
    const double stiffness = kHolding * m_model->stiffnessScale();
    for (const std::vector<Entry>& bar : {m_yarns.onComb, m_yarns.onHolder}) {
        if (!bar.empty()) {
            m_model->add(std::make_unique<physics::BarTerm>(bar, x, stiffness));
        }
    }
    std::vector<physics::KnotTerm::Knot> knots;
    for (const FabricYarns::Knot& knot : m_yarns.knots) {
        knots.push_back({knot.end, knot.at, knot.length, stiffness});
    }
    m_model->add(std::make_unique<physics::KnotTerm>(std::move(knots)));
    if (m_options.onTable) {
        const double least = isTwoFaced(m_fabric) ? kTwoFacedHalf * m_model->thickestDiameter() : 0;
        m_model->add(std::make_unique<physics::PlateTerm>(std::max(relief, least),
                                                          kPlates * m_model->stiffnessScale()));
        hold(true);
    }
    m_relaxation.emplace(*m_model, m_motion, m_options.integrator, m_options.residual);
    m_phase = Phase::Settling;
}

/// Both ends of every course, comb and stitch holder.
void YarnSettling::hold(bool held) {
    m_held = held;
    const auto pin = [&](Entry node) {
        if (node >= 0) {
            m_model->setPinned(node, held);
        }
    };
    for (const fabric::YarnCourse& course : m_fabric.courses) {
        if (course.count > 0) {
            pin(m_yarns.nodeOfPoint[static_cast<std::size_t>(course.first)]);
            pin(m_yarns.nodeOfPoint[static_cast<std::size_t>(course.first + course.count - 1)]);
        }
    }
    std::ranges::for_each(m_yarns.onComb, pin);
    std::ranges::for_each(m_yarns.onHolder, pin);
}

/// From here on friction holds what the edges held.
void YarnSettling::letGo() {
    hold(false);
    m_friction = physics::addFriction(*m_model, m_yarns.chains);
    m_relaxation.emplace(*m_model, m_motion, m_options.integrator, m_options.residual,
                         physics::YarnRelaxation::Start::Thick);
    m_energies.clear();
}

/// The energy falls by less than this share in some steps.
bool YarnSettling::isStill(double share) const {
    return m_energies.size() > kStepsAtRest &&
           m_energies[m_energies.size() - 1 - kStepsAtRest] - m_energies.back() <
               share * std::abs(m_energies.back());
}

bool YarnSettling::settle(const physics::Interrupt& interrupt) {
    if (m_friction != nullptr) {
        // Every step is one of the way: yarn that has moved holds where it is now.
        m_friction->holdAt(m_motion.positions);
        m_friction->lag(m_model->contact(), m_model->cores(), m_motion.positions);
        m_relaxation->forcesChanged();
    }
    const bool goesOn = m_relaxation->step(interrupt);
    m_report = m_relaxation->report();
    if (m_relaxation->last().outcome == physics::StepReport::Outcome::Cancelled) {
        return false;
    }
    m_energies.push_back(m_model->thickness() < 1 ? HUGE_VAL : m_report.energy);
    if (m_held) {
        if (!goesOn || isStill(kEnergyHeld)) {
            letGo();
        }
        return true;
    }
    if (goesOn && m_relaxation->takesLargeSteps() && isStill(kEnergyAtRest)) {
        m_report.verdict = StopRule::Verdict::Stagnation;
        m_phase = Phase::Done;
    }
    if (!goesOn) {
        m_phase = Phase::Done;
    }
    return m_phase != Phase::Done;
}

YarnAudit YarnSettling::audit() const {
    YarnAudit audit;
    if (*m_problem != '\0') {
        return audit;
    }
    const physics::StrandAudit strands = physics::StrandGuard(m_yarns.chains).audit(shape());
    audit.cutCorners = m_cutCorners;
    audit.coreOverlaps = strands.coreOverlaps;
    audit.deepestOverlapMm = strands.deepestOverlap * m_yarns.units.lengthMm;
    const auto loopAt = [&](Entry node) {
        return node < 0
                   ? -1
                   : m_fabric.points[static_cast<std::size_t>(m_yarns.piece[static_cast<std::size_t>(node)])]
                         .loop;
    };
    audit.worstLoop = loopAt(strands.worstA);
    audit.worstOther = loopAt(strands.worstB);
    const geometry::YarnCurves drawn = curves();
    audit.pullThroughs = geometry::certifyTopology(m_fabric, drawn).failures;
    const geometry::CrossingAudit crossings =
        geometry::auditCrossings(m_fabric, drawn, geometry::projectCrossings(drawn));
    audit.expectedCrossings = crossings.expected;
    audit.foundCrossings = crossings.found;
    return audit;
}

} // namespace knittsim::simulation
