#include "core/fabric/strand_tracker.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace knittsim::fabric {

using machine::Bed;

namespace {

constexpr double kBeside = 0.45;        ///< pitches from a needle to a yarn that waits there
constexpr double kBesideCrowded = 0.25; ///< between loops of both beds half a pitch apart

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
    const int side = sign(to.side);
    const Key target{to.pitches, side, rankBeside(side)};
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
        for (; i < m_met.size() && m_met[i].key == place; ++i) {
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
            key.rank = facingSide(i, key.x);
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

/// Loops that face each other and have no order: the one in front as if it stood on the left.
void StrandTracker::sortMet(int direction) {
    const auto isLeft = [](const Met& a, const Met& b) {
        return a.key == b.key ? a.layer > b.layer : a.key < b.key;
    };
    std::ranges::stable_sort(
        m_met, [&](const Met& a, const Met& b) { return direction > 0 ? isLeft(a, b) : isLeft(b, a); });
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
    m_book.addLoop(operation());
    for (const LoopIndex parent : m_emulator.loops().parentsOf(loop)) {
        Fate& fate = m_fates[static_cast<std::size_t>(parent)];
        fate.end = Loop::End::Bound;
        if (made.kind == machine::OperationKind::Knit) {
            fate.needle = made.needle;
            fate.rack = made.rack;
        } else {
            m_book.bar(parent, operation());
        }
    }
    inheritFacing(loop);
    m_loopAfter[static_cast<std::size_t>(yarn.number)] = loop;
    const int side = sign(made.direction);
    yarn = {.open = true,
            .key = {machine::positionPitches(made.needle, made.rack), side, rankBeside(side)},
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

} // namespace knittsim::fabric
