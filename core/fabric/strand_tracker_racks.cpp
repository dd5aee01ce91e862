// What happens while the bed racks, and the loops that face each other.

#include "core/fabric/strand_tracker.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <utility>

namespace knittsim::fabric {

using machine::Bed;

namespace {

std::uint64_t code(PassingBook::Pair pair) {
    return static_cast<std::uint64_t>(pair.over.index) << 32 | static_cast<std::uint32_t>(pair.under.index);
}

int signOf(double value) {
    return (value > 0) - (value < 0);
}

} // namespace

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
    const int direction = signOf(to - from);
    m_rackMeetings.clear();
    for (const std::int32_t rear : rearNeedles(from)) {
        leaveFacing(rear, rear + from, direction);
        collectRackMeetings(rear, from, to);
    }
    passRackMeetings(direction);
    for (const std::int32_t rear : rearNeedles(to)) {
        comeToFace(rear, rear + to, direction);
    }
}

/// Those that hold loops, the one first that holds or faces the eldest loop: an order that does not depend on
/// the side from which one looks.
std::vector<std::int32_t> StrandTracker::rearNeedles(double rack) const {
    std::vector<std::pair<LoopIndex, std::int32_t>> needles;
    std::int32_t first = 0;
    std::int32_t last = -1;
    for (const Bed bed : kRearBeds) {
        const machine::NeedleRow& row = m_emulator.state().beds[static_cast<std::size_t>(bed)];
        if (row.first() < row.end()) {
            first = last < first ? row.first() : std::min(first, row.first());
            last = std::max(last, row.end() - 1);
        }
    }
    for (std::int32_t rear = first; rear <= last; ++rear) {
        if (holdsLoop(false, rear)) {
            needles.emplace_back(std::min(eldestLoop(kRearBeds, rear), eldestLoop(kFrontBeds, rear + rack)),
                                 rear);
        }
    }
    std::ranges::sort(needles);
    std::vector<std::int32_t> order;
    std::ranges::transform(needles, std::back_inserter(order), [](const auto& n) { return n.second; });
    return order;
}

/// On the needle at `place`; the greatest number when there is none.
LoopIndex StrandTracker::eldestLoop(std::span<const Bed> beds, double place) const {
    LoopIndex eldest = std::numeric_limits<LoopIndex>::max();
    if (isWhole(place)) {
        for (const Bed bed : beds) {
            for (const LoopIndex loop : m_emulator.state().loopsOn({bed, static_cast<std::int32_t>(place)})) {
                eldest = std::min(eldest, loop);
            }
        }
    }
    return eldest;
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
    const LoopIndex ownEldest = eldestLoop(kRearBeds, rear);
    for (const Met& met : m_met) {
        const LoopIndex eldest =
            met.layer == 0 ? ownEldest : std::min(ownEldest, eldestLoop(kFrontBeds, met.key.x));
        m_rackMeetings.push_back({{met.key.x - start, met.key.side, met.key.rank}, eldest, rear, met});
    }
}

/// In the order of time, which is the same whichever of the two beds is said to move.
void StrandTracker::passRackMeetings(int direction) {
    std::ranges::stable_sort(m_rackMeetings, [direction](const RackMeeting& a, const RackMeeting& b) {
        return a.way == b.way ? a.eldest < b.eldest : direction > 0 ? a.way < b.way : b.way < a.way;
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
    turnFree();
    m_book.pass(m_pairs, m_rackOperation, ++m_moment);
}

/// Those that faced each other from the beginning and have not passed each other since stood the other way
/// round from the beginning, if that can be. All of a needle go the same way: if one of them counts, they all
/// do.
void StrandTracker::turnFree() {
    if (std::ranges::all_of(m_pairs, [&](const PassingBook::Pair& pair) { return m_book.isFree(pair); })) {
        std::size_t before = m_pairs.size() + 1;
        while (m_pairs.size() < before) {
            before = m_pairs.size();
            std::erase_if(m_pairs, [&](const PassingBook::Pair& pair) { return m_book.turnRound(pair); });
        }
    }
}

void StrandTracker::leaveFacing(std::int32_t rear, double place, int direction) {
    const int side = facingSide(rear, place);
    // Those that have had no order get that of the others, or else that in which they part.
    pairFacing(rear, place, side == 0 ? direction : side);
    for (const PassingBook::Pair& pair : m_pairs) {
        if (cameFrom(pair) == 0) {
            m_book.part(pair);
        }
    }
    pairFacing(rear, place, direction);
    for (const PassingBook::Pair& pair : m_pairs) {
        m_cameFrom.erase(code(pair));
    }
    if (side == -direction) {
        passRear();
    }
}

void StrandTracker::comeToFace(std::int32_t rear, double place, int direction) {
    pairFacing(rear, place, direction);
    if (m_pairs.empty() || m_book.meetAgain(m_pairs)) {
        return;
    }
    // Some may have passed before and thereby have not. All of a needle come to stand on the side of the
    // loops nearest to the beds.
    const bool hadPassed = m_book.passBack(m_pairs, m_rackOperation, ++m_moment);
    for (const PassingBook::Pair& pair : m_pairs) {
        m_cameFrom[code(pair)] = hadPassed ? direction : -direction;
    }
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
                const PassingBook::Pair pair = facingPair(made, parent, other);
                side = side == 0 && !m_book.isFree(pair) ? cameFrom(pair) : side;
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
