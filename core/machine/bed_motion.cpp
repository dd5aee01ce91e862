#include "core/machine/bed_motion.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace knittsim::machine {

namespace {

constexpr double kBesideNeedle = 0.5; ///< pitches from a needle to a carrier that stands beside it
constexpr double kReady = 2;          ///< pitches beyond the needles used, before the first loop
constexpr double kParked = 4;         ///< pitches beyond the needles used, out of action

bool worksAtNeedle(OperationKind kind) {
    return carriesYarn(kind) || kind == OperationKind::Drop || kind == OperationKind::Amiss ||
           kind == OperationKind::Xfer;
}

double mix(double from, double to, double t) {
    return from + (to - from) * t;
}

/// Loops that a state holds, with their needles.
struct Held {
    LoopIndex loop;
    Needle needle;
};

std::vector<Held> heldLoops(const MachineState& state) {
    std::vector<Held> held;
    for (int bed = 0; bed < kBedCount; ++bed) {
        const NeedleRow& row = state.beds[static_cast<std::size_t>(bed)];
        for (std::int32_t n = row.first(); n < row.end(); ++n) {
            for (const LoopIndex loop : row.at(n)) {
                held.push_back({loop, {static_cast<Bed>(bed), n}});
            }
        }
    }
    return held;
}

/// First and last needle that the program ever uses.
std::pair<double, double> usedNeedles(const MachineState& final) {
    double first = 0;
    double last = 0;
    bool any = false;
    for (const NeedleRow& row : final.beds) {
        if (row.first() < row.end()) {
            first = any ? std::min<double>(first, row.first()) : row.first();
            last = any ? std::max<double>(last, row.end() - 1) : row.end() - 1;
            any = true;
        }
    }
    return {first, last};
}

} // namespace

std::optional<Needle> workingNeedle(const Program& program, OperationIndex operation) {
    const auto count = static_cast<OperationIndex>(program.operations.size());
    for (OperationIndex k = std::min(operation, count - 1); k >= 0; --k) {
        const Operation& op = program.operations[static_cast<std::size_t>(k)];
        if (worksAtNeedle(op.kind)) {
            return op.needle;
        }
    }
    return std::nullopt;
}

/// Notes what the one operation did.
class BedMotion::Listener : public EmulationListener {
public:
    explicit Listener(BedMotion& motion) : m_motion(motion) {}

    void loopMade(LoopIndex loop) override {
        m_motion.m_made.push_back(loop);
        m_motion.m_madeOn = m_motion.m_timeline.loops().loops[static_cast<std::size_t>(loop)].needle;
    }
    void loopsMoved(Needle from, Needle to, std::span<const LoopIndex> loops) override {
        m_motion.m_move = Move{from, to, {loops.begin(), loops.end()}};
    }

private:
    BedMotion& m_motion;
};

BedMotion::BedMotion(const Timeline& timeline, OperationIndex operation)
    : m_timeline(timeline), m_operation(operation), m_before(timeline.stateAfter(operation)),
      m_after(m_before) {
    if (operation >= 0 && operation < timeline.operationCount()) {
        m_op = timeline.program().operations[static_cast<std::size_t>(operation)];
        Emulator emulator(timeline.program(), timeline.profile(), m_before);
        Listener listener(*this);
        emulator.step(&listener);
        m_after = emulator.takeState();
    }
    m_lastBefore = lastLoops(m_before);
    m_lastAfter = lastLoops(m_after);
    findCarriage();
    findLinks();
}

/// Where the carriage was at an operation that works at a needle.
double BedMotion::carriageAt(OperationIndex operation) const {
    const auto& operations = m_timeline.program().operations;
    const Needle needle = operations[static_cast<std::size_t>(operation)].needle;
    if (isFront(needle.bed)) {
        return needle.index;
    }
    for (OperationIndex k = operation - 1; k >= 0; --k) {
        const Operation& op = operations[static_cast<std::size_t>(k)];
        if (op.kind == OperationKind::Rack) {
            return positionPitches(needle, op.value);
        }
    }
    return needle.index;
}

void BedMotion::findCarriage() {
    const auto& operations = m_timeline.program().operations;
    const auto seenFrom = [&](OperationIndex last) -> std::optional<SeenCarriage> {
        std::optional<SeenCarriage> carriage;
        for (OperationIndex k = std::min(last, m_timeline.operationCount() - 1); k >= 0; --k) {
            const Operation& op = operations[static_cast<std::size_t>(k)];
            if (!carriage && worksAtNeedle(op.kind)) {
                carriage = SeenCarriage{carriageAt(k), 0};
            }
            if (carriesYarn(op.kind)) {
                carriage->direction = sign(op.direction);
                break;
            }
        }
        return carriage;
    };
    m_carriageBefore = seenFrom(m_operation - 1);
    m_carriageAfter = worksAtNeedle(m_op.kind) ? seenFrom(m_operation) : m_carriageBefore;
}

void BedMotion::findLinks() {
    const auto& table = m_timeline.loops().loops;
    struct Entry {
        LoopIndex loop = -1;
        std::optional<Needle> before;
        std::optional<Needle> after;
    };
    std::vector<Entry> entries;
    for (const Held& held : heldLoops(m_before)) {
        entries.push_back({held.loop, held.needle, std::nullopt});
    }
    for (const Held& held : heldLoops(m_after)) {
        entries.push_back({held.loop, std::nullopt, held.needle});
    }
    const auto yarnOf = [&](const Entry& e) { return table[static_cast<std::size_t>(e.loop)].yarn; };
    std::ranges::sort(entries, [&](const Entry& a, const Entry& b) {
        return std::tuple(yarnOf(a), a.loop, a.after.has_value()) <
               std::tuple(yarnOf(b), b.loop, b.after.has_value());
    });
    std::vector<Entry> loops; // one of each, with both needles
    for (const Entry& entry : entries) {
        if (!loops.empty() && loops.back().loop == entry.loop) {
            loops.back().after = entry.after;
        } else {
            loops.push_back(entry);
        }
    }
    for (std::size_t i = 1; i < loops.size(); ++i) {
        const Entry& a = loops[i - 1];
        const Entry& b = loops[i];
        const Loop& first = table[static_cast<std::size_t>(a.loop)];
        const Loop& second = table[static_cast<std::size_t>(b.loop)];
        const bool neighbours = first.yarn == second.yarn &&
                                std::abs(second.yarnBeginMm - second.floatMm - first.yarnEndMm) < 1e-6;
        if (!neighbours) {
            continue;
        }
        Link link;
        link.wasThere = a.before && b.before;
        link.isThere = a.after && b.after;
        if (link.wasThere) {
            link.before = {first.carrier, {*a.before, a.loop}, {*b.before, b.loop}};
        }
        if (link.isThere) {
            link.after = {first.carrier, {*a.after, a.loop}, {*b.after, b.loop}};
        }
        if (link.wasThere || link.isThere) {
            m_links.push_back(link);
        }
    }
}

BedMotion::LastLoops BedMotion::lastLoops(const MachineState& state) const {
    LastLoops last(state.carriers.size());
    for (std::size_t c = 0; c < last.size(); ++c) {
        last[c] = {state.carriers[c].place.needle, -1};
    }
    for (const Held& held : heldLoops(state)) {
        const Loop& loop = m_timeline.loops().loops[static_cast<std::size_t>(held.loop)];
        const CarrierState& carrier = state.carriers[loop.carrier];
        if (carrier.looped && carrier.yarn == loop.yarn && std::abs(carrier.fedMm - loop.yarnEndMm) < 1e-6) {
            last[loop.carrier] = {held.needle, held.loop};
        }
    }
    return last;
}

Stroke BedMotion::strokeOf(Needle needle) const {
    const bool transfer = m_op.kind == OperationKind::Xfer || m_op.kind == OperationKind::Split;
    const bool refused = transfer && !m_move && !m_before.loopsOn(m_op.needle).empty();
    if (transfer && !refused && needle == m_op.target) {
        return Stroke::Take;
    }
    if (needle != (m_made.empty() ? m_op.needle : m_madeOn)) {
        return Stroke::Rest;
    }
    switch (m_op.kind) {
    case OperationKind::Knit:
    case OperationKind::Drop:
        return Stroke::Knit;
    case OperationKind::Split:
        return refused ? Stroke::Knit : Stroke::Give;
    case OperationKind::Xfer:
        return refused ? Stroke::Tuck : Stroke::Give;
    case OperationKind::Tuck:
    case OperationKind::Amiss:
        return Stroke::Tuck;
    default:
        return Stroke::Rest;
    }
}

SeenLoop BedMotion::seen(LoopIndex loop, const NeedlePose& pose) const {
    const Loop& made = m_timeline.loops().loops[static_cast<std::size_t>(loop)];
    return {loop, made.carrier, pose.place, pose.slide, 1};
}

/// Loops of a needle that were there before, or came there from the other bed.
std::span<const LoopIndex> BedMotion::oldLoops(Needle needle, double t) const {
    using namespace phase;
    if (t >= 1) {
        return {};
    }
    const auto before = m_before.loopsOn(needle);
    if (m_move && needle == m_move->from) {
        return t < kHandOver ? before : std::span<const LoopIndex>{};
    }
    if (m_move && needle == m_move->to) {
        return t < kHandedOver ? before : m_after.loopsOn(needle);
    }
    return strokeOf(needle) == Stroke::Knit && t >= kGone ? std::span<const LoopIndex>{} : before;
}

SeenNeedle BedMotion::needleAt(Needle needle, double t, double rack) const {
    const NeedlePose pose = poseAt(strokeOf(needle), t);
    SeenNeedle made{needle, positionPitches(needle, rack), pose.height, pose.latch, {}};
    if (t >= 1) {
        for (const LoopIndex loop : m_after.loopsOn(needle)) {
            made.loops.push_back(seen(loop, {}));
        }
        return made;
    }
    const std::size_t own = m_before.loopsOn(needle).size();
    for (const LoopIndex loop : oldLoops(needle, t)) {
        const bool received = m_move && needle == m_move->to && made.loops.size() >= own;
        made.loops.push_back(seen(loop, received ? NeedlePose{} : pose));
    }
    if (t >= phase::kLaid && needle == m_madeOn) {
        for (const LoopIndex loop : m_made) {
            made.loops.push_back(seen(loop, {}));
            made.loops.back().drawn = glide(t, phase::kSinks, phase::kKnockOver);
        }
    }
    return made;
}

void BedMotion::addNeedles(BedPicture& picture, double t, BedWindow window) const {
    for (const Bed bed : {Bed::Front, Bed::Rear, Bed::FrontSlider, Bed::RearSlider}) {
        const double shift = isFront(bed) ? 0 : picture.rack;
        auto first = static_cast<std::int32_t>(std::ceil(window.first - shift));
        auto last = static_cast<std::int32_t>(std::floor(window.last - shift));
        if (isSlider(bed)) {
            const NeedleRow& used = m_timeline.finalState().beds[static_cast<std::size_t>(bed)];
            first = std::max(first, used.first());
            last = std::min(last, used.end() - 1);
        }
        for (std::int32_t n = first; n <= last; ++n) {
            picture.needles.push_back(needleAt({bed, n}, t, picture.rack));
        }
    }
    if (m_move && t >= phase::kHandOver && t < phase::kHandedOver) {
        LoopFlight flight{m_move->from, m_move->to, glide(t, phase::kHandOver, phase::kHandedOver), {}};
        for (const LoopIndex loop : m_move->loops) {
            flight.loops.push_back(seen(loop, {}));
        }
        picture.flight = std::move(flight);
    }
}

void BedMotion::addLinks(BedPicture& picture, double t, BedWindow window) const {
    const auto visible = [&](const SeenLink& link) {
        const auto [low, high] = std::minmax(
            {positionPitches(link.from.needle, picture.rack), positionPitches(link.to.needle, picture.rack)});
        return high >= window.first && low <= window.last;
    };
    for (const Link& link : m_links) {
        const bool late = link.isThere && (t >= phase::kHandedOver || !link.wasThere);
        const bool there = link.wasThere ? link.isThere || t < phase::kGone : t >= phase::kLaid;
        if (there && visible(late ? link.after : link.before)) {
            picture.links.push_back(late ? link.after : link.before);
        }
    }
}

/// Where a carrier stands that does not move.
double BedMotion::standingPlace(const CarrierState& state, CarrierIndex carrier) const {
    if (state.placed) {
        return state.place.pitches + kBesideNeedle * sign(state.place.side);
    }
    const auto [first, last] = usedNeedles(m_timeline.finalState());
    const double aside = state.in ? kReady : kParked;
    return m_timeline.program().header.carriers[carrier].parksRight ? last + aside : first - aside;
}

SeenCarrier BedMotion::carrierAt(CarrierIndex index, double t) const {
    using namespace phase;
    const CarrierState& before = m_before.carriers[index];
    const CarrierState& after = m_after.carriers[index];
    const double from = standingPlace(before, index);
    const double to = standingPlace(after, index);
    const bool loops = !m_made.empty() && m_op.carriers.contains(index);
    SeenCarrier carrier{index, m_timeline.program().header.carriers[index].rail, to, false, false, {}};
    if (t < 1) {
        const double start = after.place.pitches - kBesideNeedle * sign(m_op.direction);
        carrier.pitches = !loops         ? mix(from, to, glide(t, 0, 1))
                          : t < kArrived ? mix(from, start, glide(t, 0, kArrived))
                                         : mix(start, to, glide(t, kRisen, kSinks));
    }
    const bool late = t >= (loops ? kLaid : kGone);
    const CarrierState& now = late ? after : before;
    carrier.in = now.in;
    carrier.hooked = (late ? m_after : m_before).hook.contains(index);
    if (now.in && now.looped) {
        carrier.yarn = (late ? m_lastAfter : m_lastBefore)[index];
    }
    return carrier;
}

BedPicture BedMotion::at(double phase, BedWindow window) const {
    const double t = phase > 0 ? std::min(phase, 1.0) : 0.0;
    BedPicture picture;
    picture.rack = t >= 1 ? m_after.rack : mix(m_before.rack, m_after.rack, t);
    addNeedles(picture, t, window);
    addLinks(picture, t, window);
    for (std::size_t c = 0; c < m_after.carriers.size(); ++c) {
        if (m_timeline.finalState().carriers[c].yarn >= 0) {
            picture.carriers.push_back(carrierAt(static_cast<CarrierIndex>(c), t));
        }
    }
    picture.carriage = m_carriageAfter;
    if (m_carriageBefore && m_carriageAfter) {
        picture.carriage->pitches =
            mix(m_carriageBefore->pitches, m_carriageAfter->pitches, glide(t, 0, phase::kArrived));
    }
    if (t <= 0) {
        picture.carriage = m_carriageBefore;
    }
    return picture;
}

} // namespace knittsim::machine
