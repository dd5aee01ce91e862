#include "core/fabric/strand_tracker.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace knittsim::fabric {

using machine::Bed;

namespace {

std::uint64_t code(PassingBook::Pair pair) {
    return static_cast<std::uint64_t>(pair.over.index) << 32 | static_cast<std::uint32_t>(pair.under.index);
}

int signOf(double value) {
    return (value > 0) - (value < 0);
}

bool isWhole(double place) {
    return place == std::floor(place);
}

constexpr double kBeside = 0.45;        ///< pitches from a needle to a yarn that waits there
constexpr double kBesideCrowded = 0.25; ///< between loops of both beds half a pitch apart

constexpr std::array kFrontBeds{Bed::Front, Bed::FrontSlider};
constexpr std::array kRearBeds{Bed::Rear, Bed::RearSlider};

} // namespace

StrandTracker::StrandTracker(const machine::Emulator& emulator, const machine::Program& program)
    : m_emulator(emulator), m_program(program), m_yarns(program.header.carriers.size()) {}

std::int32_t StrandTracker::openFloat() {
    m_book.addFloat();
    m_loopAfter.push_back(-1);
    return static_cast<std::int32_t>(m_loopAfter.size()) - 1;
}

void StrandTracker::yarnMoved(CarrierIndex carrier, const machine::CarrierPlace* from,
                              const machine::CarrierPlace& to) {
    applyRack();
    ++m_rank;
    const int side = sign(to.side);
    const Key target{to.pitches, side, side > 0 ? -m_rank : m_rank};
    if (from == nullptr) {
        m_yarns[carrier] = {.open = true, .key = target, .number = openFloat()};
    } else {
        m_ways.push_back({carrier, target});
    }
    const machine::CarrierSet& all = m_program.operations[static_cast<std::size_t>(operation())].carriers;
    if (carrier != all[all.size() - 1]) {
        return;
    }
    const auto startOf = [&](const Way& way) { return m_yarns[way.carrier].key; };
    std::span<const Way> left = m_ways;
    while (!left.empty()) {
        const Key start = startOf(left[0]);
        const auto end = std::ranges::find_if_not(left, [&](const Way& way) {
            return startOf(way).x == start.x && startOf(way).side == start.side;
        });
        const auto count = static_cast<std::size_t>(end - left.begin());
        moveYarns(left.first(count));
        left = left.subspan(count);
    }
    m_ways.clear();
}

/// Yarns that start from the same place and go to the same place.
void StrandTracker::moveYarns(std::span<const Way> together) {
    Key low = together[0].to;
    Key high = low;
    for (const Way& way : together) {
        const Key& start = m_yarns[way.carrier].key;
        low = std::min({low, way.to, start});
        high = std::max({high, way.to, start});
    }
    m_met.clear();
    for (const auto& beds : {kFrontBeds, kRearBeds}) {
        for (const Bed bed : beds) {
            collectLoops(bed, low, high);
        }
    }
    // Carriers of one operation run side by side and do not pass each other.
    collectYarns(low, high, m_program.operations[static_cast<std::size_t>(operation())].carriers);
    const int direction = together[0].to > m_yarns[together[0].carrier].key ? 1 : -1;
    sortMet(direction);
    for (std::size_t i = 0; i < m_met.size();) {
        m_pairs.clear();
        const Key place = m_met[i].key;
        for (; i < m_met.size() && m_met[i].key.x == place.x && m_met[i].key.side == place.side; ++i) {
            pairYarns(together, m_met[i], direction);
        }
        m_book.pass(m_pairs, operation(), ++m_moment);
    }
    for (const Way& way : together) {
        m_yarns[way.carrier].key = way.to;
    }
}

void StrandTracker::collectLoops(Bed bed, const Key& low, const Key& high) {
    const double rack = machine::isFront(bed) ? 0 : m_emulator.state().rack;
    const auto first = static_cast<std::int32_t>(std::floor(low.x - rack));
    const auto last = static_cast<std::int32_t>(std::ceil(high.x - rack));
    const machine::NeedleRow& row = m_emulator.state().beds[static_cast<std::size_t>(bed)];
    for (std::int32_t i = std::max(first, row.first()); i <= std::min(last, row.end() - 1); ++i) {
        Key key{i + rack, 0, 0};
        if (!(low < key && key < high)) {
            continue;
        }
        if (!machine::isFront(bed) && !row.at(i).empty()) {
            // Of two loops that face each other the rear one comes first if it came from the left.
            key.rank = facingSide(i, key.x) < 0 ? -1 : 1;
        }
        for (const LoopIndex loop : row.at(i)) {
            m_met.push_back({key, {Strand::Kind::Loop, loop}, machine::isFront(bed) ? 1 : -1, 0});
        }
    }
}

void StrandTracker::collectYarns(const Key& low, const Key& high, const machine::CarrierSet& except) {
    for (std::size_t c = 0; c < m_yarns.size(); ++c) {
        const Yarn& yarn = m_yarns[c];
        const auto carrier = static_cast<CarrierIndex>(c);
        if (yarn.open && !except.contains(carrier) && low < yarn.key && yarn.key < high) {
            m_met.push_back({yarn.key, {Strand::Kind::Float, yarn.number}, 0, carrier});
        }
    }
}

void StrandTracker::sortMet(int direction) {
    std::ranges::stable_sort(m_met, [direction](const Met& a, const Met& b) {
        return direction > 0 ? a.key < b.key : b.key < a.key;
    });
}

void StrandTracker::pairYarns(std::span<const Way> together, const Met& met, int direction) {
    for (const Way& way : together) {
        const bool inFront = isInFront(way.carrier, met);
        const Yarn& yarn = m_yarns[way.carrier];
        if (std::min(yarn.key, way.to) < met.key && met.key < std::max(yarn.key, way.to)) {
            const Strand self{Strand::Kind::Float, yarn.number};
            const double place = placeOf(met.key);
            m_pairs.push_back(inFront ? PassingBook::Pair{self, met.strand, direction, place}
                                      : PassingBook::Pair{met.strand, self, -direction, place});
        }
    }
}

bool StrandTracker::isInFront(CarrierIndex carrier, const Met& met) const {
    const auto depth = [&](CarrierIndex c) { return std::pair{m_program.header.carriers[c].rail, c}; };
    return met.layer < 0 || (met.layer == 0 && depth(carrier) < depth(met.carrier));
}

void StrandTracker::loopMade(LoopIndex loop) {
    const machine::Loop& made = m_emulator.loops().loops[static_cast<std::size_t>(loop)];
    Yarn& yarn = m_yarns[made.carrier];
    m_fates.push_back({made.needle, made.rack, Loop::End::Held, isCrowded(made.needle, made.rack)});
    m_book.addLoop();
    for (const LoopIndex parent : m_emulator.loops().parentsOf(loop)) {
        Fate& fate = m_fates[static_cast<std::size_t>(parent)];
        fate.end = Loop::End::Bound;
        if (made.kind == machine::OperationKind::Knit) {
            fate.needle = made.needle;
            fate.rack = made.rack;
        } else {
            m_book.bar(parent);
        }
    }
    inheritFacing(loop);
    m_loopAfter[static_cast<std::size_t>(yarn.number)] = loop;
    ++m_rank;
    const int side = sign(made.direction);
    yarn = {.open = true,
            .key = {machine::positionPitches(made.needle, made.rack), side, side > 0 ? -m_rank : m_rank},
            .number = openFloat()};
}

void StrandTracker::loopsMoved(Needle, Needle to, std::span<const LoopIndex> loops) {
    applyRack();
    for (const LoopIndex loop : loops) {
        Fate& fate = m_fates[static_cast<std::size_t>(loop)];
        fate.needle = to;
        fate.rack = m_emulator.state().rack;
    }
}

void StrandTracker::loopsDropped(Needle needle, std::span<const LoopIndex> loops) {
    applyRack();
    for (const LoopIndex loop : loops) {
        Fate& fate = m_fates[static_cast<std::size_t>(loop)];
        fate.needle = needle;
        fate.rack = m_emulator.state().rack;
        fate.end = fate.end == Loop::End::Bound ? fate.end : Loop::End::Dropped;
    }
}

void StrandTracker::yarnCut(CarrierIndex carrier) {
    applyRack();
    m_yarns[carrier] = {};
}

/// Where along the bed a strand with this key is met, pitches. Loops that stand between loops of the other
/// bed, a fraction of a pitch aside, are given half a pitch, and the yarns beside them wait between.
double StrandTracker::placeOf(const Key& key) const {
    const double rack = m_emulator.state().rack;
    const bool front = isWhole(key.x);
    const auto index = static_cast<std::int32_t>(std::floor(front ? key.x : key.x - rack));
    if (key.side == 0 || isWhole(rack) || !isCrowded({front ? Bed::Front : Bed::Rear, index}, rack)) {
        return key.x + kBeside * key.side;
    }
    return (front ? key.x : std::floor(key.x) + 0.5) + kBesideCrowded * key.side;
}

bool StrandTracker::isCrowded(Needle needle, double rack) const {
    const bool front = machine::isFront(needle.bed);
    const double facing = front ? needle.index - rack : needle.index + rack;
    return !isWhole(facing) && (holdsLoop(!front, static_cast<std::int32_t>(std::floor(facing))) ||
                                holdsLoop(!front, static_cast<std::int32_t>(std::ceil(facing))));
}

bool StrandTracker::holdsLoop(bool front, std::int32_t index) const {
    return std::ranges::any_of(front ? kFrontBeds : kRearBeds, [&](Bed bed) {
        return !m_emulator.state().loopsOn({bed, index}).empty();
    });
}

void StrandTracker::racked(double from, double to) {
    m_rackOperation = operation();
    m_rackFrom = m_rackFrom.value_or(from);
    m_rackTo = to;
}

void StrandTracker::applyRack() {
    const double from = m_rackFrom.value_or(m_rackTo);
    const double to = m_rackTo;
    m_rackFrom.reset();
    if (from == to) {
        return;
    }
    std::int32_t first = 0;
    std::int32_t last = -1;
    for (const Bed bed : kRearBeds) {
        const machine::NeedleRow& row = m_emulator.state().beds[static_cast<std::size_t>(bed)];
        if (row.first() < row.end()) {
            first = last < first ? row.first() : std::min(first, row.first());
            last = std::max(last, row.end() - 1);
        }
    }
    const int direction = signOf(to - from);
    m_rackMeetings.clear();
    for (std::int32_t rear = first; rear <= last; ++rear) {
        if (holdsLoop(false, rear)) {
            leaveFacing(rear, rear + from, direction);
            collectRackMeetings(rear, from, to);
        }
    }
    passRackMeetings(direction);
    for (std::int32_t rear = first; rear <= last; ++rear) {
        if (holdsLoop(false, rear)) {
            comeToFace(rear, rear + to, direction);
        }
    }
}

void StrandTracker::collectRackMeetings(std::int32_t rear, double from, double to) {
    const double start = rear + from;
    const double end = rear + to;
    const Key low{std::min(start, end), 0, 0};
    const Key high{std::max(start, end), 0, 0};
    m_met.clear();
    for (const Bed bed : kFrontBeds) {
        collectLoops(bed, low, high);
    }
    collectYarns(low, high, {});
    for (const Met& met : m_met) {
        m_rackMeetings.push_back({{met.key.x - start, met.key.side, met.key.rank}, rear, met});
    }
}

/// In the order of time, which is the same whichever of the two beds is said to move.
void StrandTracker::passRackMeetings(int direction) {
    std::ranges::stable_sort(m_rackMeetings, [direction](const RackMeeting& a, const RackMeeting& b) {
        return a.way == b.way ? a.rear < b.rear : direction > 0 ? a.way < b.way : b.way < a.way;
    });
    for (std::size_t i = 0; i < m_rackMeetings.size();) {
        m_pairs.clear();
        const RackMeeting first = m_rackMeetings[i];
        for (; i < m_rackMeetings.size() && m_rackMeetings[i].way == first.way &&
               m_rackMeetings[i].rear == first.rear;
             ++i) {
            pairRear(m_rackMeetings[i].met.strand, first.rear, direction, placeOf(first.met.key));
        }
        passRear();
    }
}

void StrandTracker::pairRear(Strand over, std::int32_t rear, int direction, double place) {
    for (const Bed bed : kRearBeds) {
        for (const LoopIndex loop : m_emulator.state().loopsOn({bed, rear})) {
            m_pairs.push_back({over, {Strand::Kind::Loop, loop}, -direction, place});
        }
    }
}

void StrandTracker::passRear() {
    settleFree();
    m_book.pass(m_pairs, m_rackOperation, ++m_moment);
}

/// All of a needle go the same way: if one of them counts, they all do from now on.
void StrandTracker::settleFree() {
    if (std::ranges::all_of(m_pairs, [&](const PassingBook::Pair& pair) { return isFree(pair); })) {
        m_pairs.clear();
    }
    for (const PassingBook::Pair& pair : m_pairs) {
        if (pair.over.kind == Strand::Kind::Loop) {
            m_facedFromStart.erase(code(pair));
        }
    }
}

void StrandTracker::leaveFacing(std::int32_t rear, double place, int direction) {
    const int side = facingSide(rear, place);
    pairFacing(rear, place, direction);
    for (const PassingBook::Pair& pair : m_pairs) {
        m_cameFrom.erase(code(pair));
    }
    if (side == 0) {
        for (const PassingBook::Pair& pair : m_pairs) {
            m_facedFromStart.insert(code(pair));
        }
    } else if (side == -direction) {
        passRear();
    }
}

void StrandTracker::comeToFace(std::int32_t rear, double place, int direction) {
    pairFacing(rear, place, direction);
    settleFree();
    if (m_pairs.empty()) {
        return;
    }
    // Some may have passed before and thereby have not. All of a needle come to stand on the side of the
    // loops nearest to the beds.
    const std::span<const PassingBook::Pair> all = m_pairs;
    const bool hadPassed = m_book.undo(all.first(1)).empty();
    if (hadPassed) {
        m_book.pass(all.subspan(1), m_rackOperation, ++m_moment);
    }
    for (const PassingBook::Pair& pair : m_pairs) {
        m_cameFrom[code(pair)] = hadPassed ? direction : -direction;
    }
}

bool StrandTracker::isFree(PassingBook::Pair pair) const {
    return pair.over.kind == Strand::Kind::Loop && m_facedFromStart.contains(code(pair)) &&
           !m_book.havePassed(pair.over, pair.under);
}

/// Side from which the loops of a rear needle at `place` came to face those of the front needle there: -1
/// left, +1 right, 0 when they face each other from the beginning.
int StrandTracker::facingSide(std::int32_t rear, double place) {
    if (m_cameFrom.empty()) {
        return 0;
    }
    pairFacing(rear, place, 1);
    for (const PassingBook::Pair& pair : m_pairs) {
        if (const int side = cameFrom(pair); side != 0) {
            return side;
        }
    }
    return 0;
}

int StrandTracker::cameFrom(PassingBook::Pair pair) const {
    const auto found = m_cameFrom.find(code(pair));
    return found == m_cameFrom.end() ? 0 : found->second;
}

/// A loop that is drawn through others faces what they face, and from the same side.
void StrandTracker::inheritFacing(LoopIndex loop) {
    const machine::Loop& made = m_emulator.loops().loops[static_cast<std::size_t>(loop)];
    const double facing =
        machine::isFront(made.needle.bed) ? made.needle.index - made.rack : made.needle.index + made.rack;
    if (m_cameFrom.empty() || !isWhole(facing)) {
        return;
    }
    for (const Bed bed : machine::isFront(made.needle.bed) ? kRearBeds : kFrontBeds) {
        for (const LoopIndex other : m_emulator.state().loopsOn({bed, static_cast<std::int32_t>(facing)})) {
            int side = 0;
            for (const LoopIndex parent : m_emulator.loops().parentsOf(loop)) {
                side = side == 0 ? cameFrom(facingPair(made, parent, other)) : side;
            }
            if (side != 0) {
                m_cameFrom[code(facingPair(made, loop, other))] = side;
            }
        }
    }
}

PassingBook::Pair StrandTracker::facingPair(const machine::Loop& made, LoopIndex own, LoopIndex other) const {
    const Strand a{Strand::Kind::Loop, own};
    const Strand b{Strand::Kind::Loop, other};
    return machine::isFront(made.needle.bed) ? PassingBook::Pair{a, b} : PassingBook::Pair{b, a};
}

/// All pairs of loops of a rear needle at `place` and the front needle there.
void StrandTracker::pairFacing(std::int32_t rear, double place, int direction) {
    m_pairs.clear();
    if (!isWhole(place)) {
        return;
    }
    for (const Bed bed : kFrontBeds) {
        for (const LoopIndex over : m_emulator.state().loopsOn({bed, static_cast<std::int32_t>(place)})) {
            pairRear({Strand::Kind::Loop, over}, rear, direction, place);
        }
    }
}

} // namespace knittsim::fabric
