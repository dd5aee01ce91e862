#include "core/simulation/yarn_settling.h"

#include "core/physics/yarn_model/bar_term.h"
#include "core/physics/yarn_model/knot_term.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace knittsim::simulation {

namespace {

using physics::Entry;
using physics::StopRule;
using physics::YarnRelaxation;

constexpr int kSweepsAtOnce = 10;
constexpr int kMostSweeps = 200;
constexpr int kMostGrownSweeps = 150; ///< at full thickness; the rods make the rest of the room
constexpr double kCoarseFrom = 0.5;   ///< thickness
constexpr int kStraightening = 12;
constexpr double kStraight = 1e-6;    ///< d
constexpr double kFree = 0.5;         ///< share of its way that a straightened node is free to go at least
constexpr std::ptrdiff_t kBent = 50;  ///< one of so many may stay bent
constexpr double kRoomEnough = 1.03;  ///< distance over core diameter
constexpr double kHolding = 1;        ///< stiffness of comb, holder and knots against that of a segment
constexpr double kPull = 2;           ///< stiffness of a person's pull, EI/d^3
constexpr double kTwoFacedHalf = 2.4; ///< diameters: a rib is 3.4 to 4.8 thick (PHYSICS-REFERENCE 3.3)
/// A fabric whose energy falls by less in so many steps is at rest for all that one can measure of it: what
/// still moves are loose ends.
constexpr double kEnergyAtRest = 1e-3; ///< without friction it must not go on: stitches slide into heaps
constexpr double kEnergyHeld = 1e-2;
constexpr double kEnergyPulled = 1e-4; ///< what a person pulls is to follow
constexpr std::size_t kStepsAtRest = 8;
constexpr int kStepsOfLag = 30;
constexpr int kMostLags = 12;
constexpr double kOneFacedHalf = 1; ///< diameters: plain knit is 2.0 to 2.2 thick, and edges need some room

std::vector<Entry> endsOf(const physics::YarnChains& chains) {
    std::vector<Entry> ends;
    for (const physics::Chain& chain : chains.chains) {
        ends.insert(ends.end(), {chain.first, chain.first + chain.count - 1});
    }
    return ends;
}

bool isFew(std::ptrdiff_t bent, std::size_t nodes) {
    return kBent * bent <= static_cast<std::ptrdiff_t>(nodes);
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
    m_witness.emplace(m_yarns.chains);
    m_laid = m_yarns;
}

bool YarnSettling::step(const physics::Interrupt& interrupt) {
    if (interrupt.wanted() || m_phase == Phase::Done) {
        return false;
    }
    if (m_phase == Phase::Growing) {
        grow(interrupt);
        return !interrupt.wanted();
    }
    return settle(interrupt);
}

void YarnSettling::grow(const physics::Interrupt& interrupt) {
    int sweeps = 0;
    while (sweeps < kSweepsAtOnce && !interrupt.wanted()) {
        const physics::Vector before = shape();
        m_growth->sweep(m_motion.positions);
        witness(before);
        ++sweeps;
    }
    m_sweeps += sweeps;
    if (sweeps < kSweepsAtOnce) {
        return;
    }
    if (m_dense) {
        if (m_growth->thickness() >= kCoarseFrom) {
            const std::vector<char> bent = straighten();
            if (m_sweeps >= kMostSweeps || isFew(std::ranges::count(bent, 1), bent.size())) {
                coarsen(bent);
            }
        }
        return;
    }
    m_grownSweeps += m_growth->thickness() >= 1 ? kSweepsAtOnce : 0;
    if (m_grownSweeps > 0 && (m_growth->room() > kRoomEnough || m_grownSweeps >= kMostGrownSweeps)) {
        startSettling();
    }
}

/// What moved since `from` went through nothing, or it is written down.
void YarnSettling::witness(const physics::Vector& from) {
    for (const physics::StrandWitness::Meeting& meeting : m_witness->follow(from, shape())) {
        m_passages.push_back({loopAt(meeting.a), loopAt(meeting.b)});
    }
}

/// Every second node goes between its neighbours as far as no strand is in the way. Returns by node
/// who does not get there.
std::vector<char> YarnSettling::straighten() {
    physics::Vector& x = m_motion.positions;
    const auto nodes = static_cast<std::size_t>(m_yarns.chains.nodeCount());
    std::vector<char> bent(nodes, 0);
    physics::StrandGuard guard(m_yarns.chains);
    for (int round = 0; round < kStraightening; ++round) {
        physics::Vector move = physics::Vector::Zero(x.size());
        bool straight = true;
        for (const physics::Chain& chain : m_yarns.chains.chains) {
            for (Entry e = chain.first + 1; e < chain.first + chain.count - 1; e += 2) {
                const double before = m_yarns.chains.restLength[static_cast<std::size_t>(e) - 1];
                const double after = m_yarns.chains.restLength[static_cast<std::size_t>(e)];
                const Eigen::Vector3d middle =
                    (after * physics::at(x, e - 1) + before * physics::at(x, e + 1)) / (before + after);
                physics::at(move, e) = middle - physics::at(x, e);
                const bool bends = physics::at(move, e).norm() > kStraight;
                bent[static_cast<std::size_t>(e)] = bends ? 1 : 0;
                straight = straight && !bends;
            }
        }
        if (straight) {
            break;
        }
        std::vector<double> share(nodes, 1);
        guard.lowerShares(x, move, share);
        for (std::size_t e = 0; e < nodes; ++e) {
            // Pressed on and on, strands would end up touching.
            physics::at(move, static_cast<Entry>(e)) *= share[e] < kFree ? 0 : share[e];
        }
        const physics::Vector from = x;
        x += guard.allowed(x, move) * move;
        witness(from);
    }
    return bent;
}

/// Leaves out every second node but the bent ones.
void YarnSettling::coarsen(const std::vector<char>& bent) {
    const double thickness = m_growth->thickness();
    m_yarns = withHalfTheNodes(m_fabric, m_yarns, m_motion.positions, bent);
    m_motion.positions = m_yarns.chains.start();
    m_motion.velocities.setZero(m_motion.positions.size());
    m_growth.emplace(m_yarns.chains, endsOf(m_yarns.chains), thickness);
    m_witness.emplace(m_yarns.chains);
    m_dense = false;
}

/// To the spacings where settling begins: stretched along the axes, so nothing passes through another.
void YarnSettling::bringBack() {
    const Vec3 factor(1 / m_options.layout.wider, 1 / m_options.layout.higher, 1);
    const physics::Vector from = shape();
    for (Entry e = 0; e < m_yarns.chains.nodeCount(); ++e) {
        physics::at(m_motion.positions, e) = physics::at(from, e).cwiseProduct(factor);
    }
    witness(from);
}

void YarnSettling::startSettling() {
    m_growth.reset();
    bringBack();
    const double relief = centreRelief(m_motion.positions);
    const double thickest = physics::thickestYarn(m_yarns.chains.yarns);
    m_halfGap = std::max(relief, (isTwoFaced(m_fabric) ? kTwoFacedHalf : kOneFacedHalf) * thickest);
    m_grown = m_motion.positions;
    const bool free = m_options.surroundings == Surroundings::Free;
    build(free ? Stage::Shaken : Stage::Held, YarnRelaxation::Start::Thin);
}

/// Plates and pins keep the fabric flat; else it finds a shape in space, which friction would hold back.
bool YarnSettling::curls() const {
    return m_options.surroundings != Surroundings::Flat && m_options.surroundings != Surroundings::Pinned;
}

YarnSettling::Stage YarnSettling::stageAfter(Stage stage) const {
    if (stage == Stage::Held && curls()) {
        return Stage::Shaken;
    }
    return m_options.surroundings == Surroundings::Free ? stage : Stage::Rubbed;
}

/// A new model of the present yarns at the present shape.
void YarnSettling::build(Stage stage, YarnRelaxation::Start start) {
    if (m_relaxation) {
        m_earlier.addWork(m_relaxation->report());
        m_relaxation.reset();
    }
    m_friction = nullptr;
    m_stage = stage;
    m_model = std::make_unique<physics::YarnModel>(m_yarns.chains);
    addHoldings();
    const bool held = stage == Stage::Held;
    surround(*m_model, m_fabric, m_yarns, shape(), held ? Surroundings::Flat : m_options.surroundings,
             m_halfGap);
    for (const Entry e : held ? edgeNodes(m_fabric, m_yarns) : std::vector<Entry>()) {
        m_model->setPinned(e, true);
    }
    for (const fabric::PointIndex point : m_pins) {
        m_model->setPinned(nodeAt(point), true);
    }
    if (stage == Stage::Rubbed) {
        m_friction = physics::addFriction(*m_model, m_yarns.chains);
    }
    wake();
    m_relaxation.emplace(*m_model, m_motion, m_options.integrator, m_options.residual, start);
}

/// Comb, stitch holder, knots and a person's pull.
void YarnSettling::addHoldings() {
    const double stiffness = kHolding * m_model->stiffnessScale();
    for (const std::vector<Entry>& bar : {m_yarns.onComb, m_yarns.onHolder}) {
        if (!bar.empty()) {
            m_model->add(std::make_unique<physics::BarTerm>(bar, m_grown, stiffness));
        }
    }
    std::vector<physics::KnotTerm::Knot> knots;
    for (const FabricYarns::Knot& knot : m_yarns.knots) {
        knots.push_back({knot.end, knot.at, knot.length, stiffness});
    }
    m_model->add(std::make_unique<physics::KnotTerm>(std::move(knots)));
    auto pull = std::make_unique<physics::DragTerm>();
    m_pull = pull.get();
    m_model->add(std::move(pull));
    if (m_pulled) {
        m_pull->pulls() = {{nodeAt(m_pulled->point), m_pulled->place / m_yarns.units.lengthMm, kPull}};
    }
}

/// What came to rest moves again.
void YarnSettling::wake() {
    m_phase = Phase::Settling;
    m_energies.clear();
    m_untilLag = 0;
    m_lags = 0;
}

/// -1 where no yarn was laid.
Entry YarnSettling::nodeAt(fabric::PointIndex point) const {
    const bool known = point >= 0 && static_cast<std::size_t>(point) < m_yarns.nodeOfPoint.size();
    return known ? m_yarns.nodeOfPoint[static_cast<std::size_t>(point)] : -1;
}

void YarnSettling::setYarn(machine::CarrierIndex carrier, const yarn::Yarn& yarn) {
    if (*m_problem != '\0' || carrier >= m_yarns.chains.yarns.size()) {
        return;
    }
    const double before = physics::thickestYarn(m_yarns.chains.yarns);
    simulation::setYarn(m_yarns, carrier, yarn);
    m_halfGap *= physics::thickestYarn(m_yarns.chains.yarns) / before;
    if (m_growth) {
        m_growth.emplace(m_yarns.chains, endsOf(m_yarns.chains), m_growth->thickness());
        m_grownSweeps = 0;
    } else {
        build(m_stage == Stage::Held ? Stage::Held : Stage::Shaken, YarnRelaxation::Start::Thin);
    }
}

void YarnSettling::setSurroundings(Surroundings surroundings) {
    const bool changes = surroundings != m_options.surroundings;
    m_options.surroundings = surroundings;
    if (changes && m_model) {
        const bool held = m_stage == Stage::Held && surroundings != Surroundings::Free;
        build(held ? Stage::Held : stageAfter(Stage::Held), YarnRelaxation::Start::Thick);
    }
}

void YarnSettling::drag(fabric::PointIndex point, const Vec3& place) {
    if (nodeAt(point) < 0 || !place.allFinite()) {
        return;
    }
    m_pulled = Pull{point, place};
    if (m_model) {
        m_pull->pulls() = {{nodeAt(point), place / m_yarns.units.lengthMm, kPull}};
        m_relaxation->restart();
        wake();
    }
}

void YarnSettling::release() {
    if (std::exchange(m_pulled, std::nullopt) && m_model) {
        m_pull->pulls().clear();
        m_relaxation->restart();
        wake();
    }
}

void YarnSettling::setPinned(fabric::PointIndex point, bool pinned) {
    if (nodeAt(point) < 0) {
        return;
    }
    std::erase(m_pins, point);
    if (pinned) {
        m_pins.push_back(point);
    }
    if (m_model) {
        build(m_stage, YarnRelaxation::Start::Thick);
    }
}

/// The energy falls by less than this share in some steps.
bool YarnSettling::isStill(double share) const {
    return m_energies.size() > kStepsAtRest &&
           m_energies[m_energies.size() - 1 - kStepsAtRest] - m_energies.back() <
               share * std::abs(m_energies.back());
}

/// Yarn that has moved holds where it is now.
void YarnSettling::lagFriction() {
    m_friction->holdAt(m_motion.positions);
    m_friction->lag(m_model->contact(), m_model->cores(), m_motion.positions);
    m_relaxation->forcesChanged();
}

/// Friction looks anew, once it has come to rest. False when nothing is left to do: then the forces are in
/// balance, or come no nearer to it.
bool YarnSettling::balance() {
    lagFriction();
    physics::Vector force;
    m_report.energy = m_model->evaluate(shape(), &force);
    m_relaxation->measureAgainst(pressing().norm());
    const double before = m_unbalanced;
    m_unbalanced = m_relaxation->residual(force.norm());
    m_report.residual = m_unbalanced;
    if (m_unbalanced <= m_options.residual) {
        m_report.verdict = StopRule::Verdict::ResidualReached;
        return false;
    }
    if (++m_lags > kMostLags || (m_lags > 1 && m_unbalanced >= before)) {
        m_report.verdict = StopRule::Verdict::Stagnation;
        return false;
    }
    m_relaxation->restart();
    m_untilLag = kStepsOfLag;
    return true;
}

bool YarnSettling::settle(const physics::Interrupt& interrupt) {
    if (m_friction != nullptr && m_untilLag == 0) {
        lagFriction();
    }
    const physics::Vector before = shape();
    const bool goesOn = m_relaxation->step(interrupt);
    witness(before);
    m_report = m_relaxation->report();
    m_report.addWork(m_earlier);
    if (m_relaxation->last().outcome == physics::StepReport::Outcome::Cancelled) {
        return false;
    }
    m_energies.push_back(m_model->thickness() < 1 ? HUGE_VAL : m_report.energy);
    const Stage next = stageAfter(m_stage);
    if (next != m_stage) {
        if (!goesOn || isStill(m_stage == Stage::Shaken ? kEnergyAtRest : kEnergyHeld)) {
            build(next, YarnRelaxation::Start::Thick);
        }
        return true;
    }
    const bool pauses = !goesOn || (m_untilLag > 0 ? --m_untilLag == 0
                                                   : m_relaxation->takesLargeSteps() &&
                                                         isStill(m_pulled ? kEnergyPulled : kEnergyAtRest));
    if (!pauses) {
        return true;
    }
    const bool balances = m_friction != nullptr && !m_pulled && (goesOn || isAtRest(m_report.verdict));
    if (!balances && goesOn) {
        m_report.verdict = StopRule::Verdict::Stagnation;
    }
    if (!balances || !balance()) {
        m_phase = Phase::Done;
    }
    return m_phase != Phase::Done;
}

} // namespace knittsim::simulation
