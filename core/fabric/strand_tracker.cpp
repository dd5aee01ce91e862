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
        const auto stack = stackAt(i);
        m_moment += i > 0 && m_met[i - 1].key.x == stack[0].key.x && m_met[i - 1].key.side == 0 ? 0 : 1;
        passYarns(together, stack, direction);
        i += stack.size();
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
        const Key key{i + rack, 0, machine::isFront(bed) ? 0 : 1};
        if (!(low < key && key < high)) {
            continue;
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

/// The loops of one needle, or one yarn.
std::span<const StrandTracker::Met> StrandTracker::stackAt(std::size_t first) const {
    const auto rest = std::span(m_met).subspan(first);
    const auto end = std::ranges::find_if_not(rest, [&](const Met& met) { return met.key == rest[0].key; });
    return rest.first(static_cast<std::size_t>(end - rest.begin()));
}

void StrandTracker::passYarns(std::span<const Way> together, std::span<const Met> stack, int direction) {
    m_pairs.clear();
    const bool inFront = isInFront(together[0].carrier, stack[0]);
    for (const Way& way : together) {
        const Yarn& yarn = m_yarns[way.carrier];
        const Key& key = stack[0].key;
        if (std::min(yarn.key, way.to) < key && key < std::max(yarn.key, way.to)) {
            const Strand self{Strand::Kind::Float, yarn.number};
            for (const Met& met : stack) {
                m_pairs.push_back(inFront ? PassingBook::Pair{self, met.strand}
                                          : PassingBook::Pair{met.strand, self});
            }
        }
    }
    m_book.pass(m_pairs, inFront ? direction : -direction, operation(), m_moment);
}

bool StrandTracker::isInFront(CarrierIndex carrier, const Met& met) const {
    const auto depth = [&](CarrierIndex c) { return std::pair{m_program.header.carriers[c].rail, c}; };
    return met.layer < 0 || (met.layer == 0 && depth(carrier) < depth(met.carrier));
}

void StrandTracker::loopMade(LoopIndex loop) {
    const machine::Loop& made = m_emulator.loops().loops[static_cast<std::size_t>(loop)];
    Yarn& yarn = m_yarns[made.carrier];
    m_fates.push_back({made.needle, made.rack, Loop::End::Held});
    m_stay.push_back(++m_stayCount);
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

void StrandTracker::loopsMoved(Needle from, Needle to, std::span<const LoopIndex> loops) {
    const bool fromFront = machine::isFront(from.bed);
    for (const LoopIndex loop : loops) {
        const auto i = static_cast<std::size_t>(loop);
        m_fates[i].needle = to;
        m_fates[i].rack = m_emulator.state().rack;
        std::vector<Move>& moves = m_movesOf[loop];
        if (!moves.empty() && moves.back().fromFront != fromFront && moves.back().after == markOf(loop)) {
            m_stay[i] = moves.back().stayBefore; // came back unchanged: as if it had never left
            moves.pop_back();
        } else {
            const std::int32_t before = m_stay[i];
            m_stay[i] = ++m_stayCount;
            moves.push_back({fromFront, before, markOf(loop)});
        }
    }
}

void StrandTracker::loopsDropped(Needle needle, std::span<const LoopIndex> loops) {
    for (const LoopIndex loop : loops) {
        Fate& fate = m_fates[static_cast<std::size_t>(loop)];
        fate = {needle, m_emulator.state().rack,
                fate.end == Loop::End::Bound ? fate.end : Loop::End::Dropped};
    }
}

void StrandTracker::yarnCut(CarrierIndex carrier) {
    m_yarns[carrier] = {};
}

bool StrandTracker::holdsLoop(bool front, std::int32_t index) const {
    return std::ranges::any_of(front ? kFrontBeds : kRearBeds, [&](Bed bed) {
        return !m_emulator.state().loopsOn({bed, index}).empty();
    });
}

void StrandTracker::racked(double from, double to) {
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
    // The needle that leads passes first, so that passings are in the order of time on every strand.
    for (std::int32_t n = 0; n <= last - first; ++n) {
        const std::int32_t rear = to > from ? last - n : first + n;
        if (holdsLoop(false, rear)) {
            rackNeedle(rear, from, to);
        }
    }
}

void StrandTracker::rackNeedle(std::int32_t rear, double from, double to) {
    const int direction = signOf(to - from);
    const double start = rear + from;
    const double end = rear + to;
    if (isWhole(start) && holdsLoop(true, static_cast<std::int32_t>(start))) {
        leaveFacing(rear, static_cast<std::int32_t>(start), direction);
    }
    const Key low{std::min(start, end), 0, 0};
    const Key high{std::max(start, end), 0, 0};
    m_met.clear();
    for (const Bed bed : kFrontBeds) {
        collectLoops(bed, low, high);
    }
    collectYarns(low, high, {});
    sortMet(direction);
    for (std::size_t i = 0; i < m_met.size();) {
        const auto stack = stackAt(i);
        passRear(stack, rear, direction);
        i += stack.size();
    }
    if (isWhole(end) && holdsLoop(true, static_cast<std::int32_t>(end))) {
        comeToFace(rear, static_cast<std::int32_t>(end), direction);
    }
}

void StrandTracker::passRear(std::span<const Met> stack, std::int32_t rear, int direction) {
    m_pairs.clear();
    for (const Met& met : stack) {
        for (const Bed bed : kRearBeds) {
            for (const LoopIndex loop : m_emulator.state().loopsOn({bed, rear})) {
                m_pairs.push_back({met.strand, {Strand::Kind::Loop, loop}});
            }
        }
    }
    std::erase_if(m_pairs, [&](PassingBook::Pair pair) { return isFree(pair); });
    passLoops(direction);
}

/// The rear loops of m_pairs go in `direction` past the front loops.
void StrandTracker::passLoops(int direction) {
    m_book.pass(m_pairs, -direction, operation(), ++m_moment);
}

void StrandTracker::leaveFacing(std::int32_t rear, std::int32_t front, int direction) {
    pairFacing(rear, front);
    std::erase_if(m_pairs, [&](PassingBook::Pair pair) {
        const int side = cameFrom(pair);
        if (side == 0) {
            m_free[code(pair)] = marksOf(pair);
        }
        m_cameFrom.erase(code(pair));
        return side != -direction;
    });
    passLoops(direction);
}

void StrandTracker::comeToFace(std::int32_t rear, std::int32_t front, int direction) {
    pairFacing(rear, front);
    std::erase_if(m_pairs, [&](PassingBook::Pair pair) { return isFree(pair); });
    for (const PassingBook::Pair& pair : m_pairs) {
        m_free.erase(code(pair));
        m_cameFrom[code(pair)] = direction; // unless they have not passed before
    }
    for (const PassingBook::Pair& pair : m_book.undo(m_pairs, -direction)) {
        m_cameFrom[code(pair)] = -direction;
    }
}

int StrandTracker::cameFrom(PassingBook::Pair pair) const {
    const auto found = m_cameFrom.find(code(pair));
    return found == m_cameFrom.end() ? 0 : found->second;
}

/// A loop that is drawn through others faces what they face, and from the same side.
void StrandTracker::inheritFacing(LoopIndex loop) {
    const machine::Loop& made = m_emulator.loops().loops[static_cast<std::size_t>(loop)];
    const double facing = machine::isFront(made.needle.bed) ? made.needle.index - made.rack : made.needle.index + made.rack;
    if (m_cameFrom.empty() || !isWhole(facing)) {
        return;
    }
    for (const Bed bed : machine::isFront(made.needle.bed) ? kRearBeds : kFrontBeds) {
        for (const LoopIndex other :
             m_emulator.state().loopsOn({bed, static_cast<std::int32_t>(facing)})) {
            int side = 0;
            for (const LoopIndex parent : m_emulator.loops().parentsOf(loop)) {
                const PassingBook::Pair pair = facingPair(made, parent, other);
                const int own = cameFrom(pair);
                side = side == 0 ? own : side;
                if (own == -side && own != 0) {
                    // Where the parents differ, the others pass so that they all agree.
                    m_pairs = {pair};
                    passLoops(side);
                }
            }
            if (side != 0) {
                m_cameFrom[code(facingPair(made, loop, other))] = side;
            }
        }
    }
}

PassingBook::Pair StrandTracker::facingPair(const machine::Loop& made, LoopIndex own,
                                            LoopIndex other) const {
    const Strand a{Strand::Kind::Loop, own};
    const Strand b{Strand::Kind::Loop, other};
    return machine::isFront(made.needle.bed) ? PassingBook::Pair{a, b} : PassingBook::Pair{b, a};
}

/// All pairs of loops of two needles that face each other.
void StrandTracker::pairFacing(std::int32_t rear, std::int32_t front) {
    m_pairs.clear();
    for (const Bed frontBed : kFrontBeds) {
        for (const LoopIndex over : m_emulator.state().loopsOn({frontBed, front})) {
            for (const Bed rearBed : kRearBeds) {
                for (const LoopIndex under : m_emulator.state().loopsOn({rearBed, rear})) {
                    m_pairs.push_back({{Strand::Kind::Loop, over}, {Strand::Kind::Loop, under}});
                }
            }
        }
    }
}

/// The two faced each other from the beginning, and nothing has happened to them since they parted.
bool StrandTracker::isFree(PassingBook::Pair pair) const {
    if (pair.over.kind == Strand::Kind::Float) {
        return false;
    }
    const auto found = m_free.find(code(pair));
    return found != m_free.end() && found->second == marksOf(pair);
}

std::pair<StrandTracker::Mark, StrandTracker::Mark> StrandTracker::marksOf(PassingBook::Pair pair) const {
    return {markOf(pair.over.index), markOf(pair.under.index)};
}

StrandTracker::Mark StrandTracker::markOf(LoopIndex loop) const {
    const auto& on = m_book.on({Strand::Kind::Loop, loop});
    return {m_stay[static_cast<std::size_t>(loop)], on.size(), on.empty() ? 0 : on.back()};
}

} // namespace knittsim::fabric
