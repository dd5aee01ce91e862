#include "core/fabric/strand_tracker.h"

#include <algorithm>
#include <cmath>

namespace knittsim::fabric {

using machine::Bed;

namespace {

std::uint64_t code(Strand strand) {
    return static_cast<std::uint64_t>(strand.index) * 2 + (strand.kind == Strand::Kind::Float ? 1 : 0);
}

std::uint64_t pairCode(Strand a, Strand b) {
    const auto [low, high] = std::minmax({code(a), code(b)});
    return low << 32 | high;
}

int signOf(double value) {
    return (value > 0) - (value < 0);
}

constexpr double kBeside = 0.45; ///< pitches

constexpr std::array kFrontBeds{Bed::Front, Bed::FrontSlider};
constexpr std::array kRearBeds{Bed::Rear, Bed::RearSlider};

} // namespace

StrandTracker::StrandTracker(const machine::Emulator& emulator, const machine::Program& program)
    : m_emulator(emulator), m_program(program), m_yarns(program.header.carriers.size()) {}

std::int32_t StrandTracker::openFloat() {
    m_loopAfter.push_back(-1);
    return static_cast<std::int32_t>(m_loopAfter.size()) - 1;
}

std::int32_t& StrandTracker::stay(Strand strand) {
    return strand.kind == Strand::Kind::Loop ? m_stay[static_cast<std::size_t>(strand.index)] : m_floatStay;
}

void StrandTracker::countOpen(const Passing& passing, int change) {
    for (const Strand strand : {passing.over, passing.under}) {
        if (strand.kind == Strand::Kind::Loop) {
            m_openPassings[static_cast<std::size_t>(strand.index)] += change;
        }
    }
}

void StrandTracker::pass(Strand over, Strand under, int sign, double place) {
    const auto [latest, isNew] = m_last.try_emplace(pairCode(over, under), -1);
    if (latest->second >= 0) {
        Passing& last = m_passings[static_cast<std::size_t>(latest->second)];
        if (last.over == over && last.sign == -sign && last.overStay == stay(over) &&
            last.underStay == stay(under)) {
            last.undone = true;
            countOpen(last, -1);
            latest->second = last.previous;
            return;
        }
    }
    m_passings.push_back({.over = over,
                          .under = under,
                          .operation = operation(),
                          .sign = static_cast<std::int8_t>(sign),
                          .place = static_cast<float>(place),
                          .previous = latest->second,
                          .overStay = stay(over),
                          .underStay = stay(under)});
    countOpen(m_passings.back(), +1);
    latest->second = static_cast<std::int32_t>(m_passings.size()) - 1;
}

void StrandTracker::yarnMoved(CarrierIndex carrier, const machine::CarrierPlace* from,
                              const machine::CarrierPlace& to) {
    Yarn& yarn = m_yarns[carrier];
    ++m_rank;
    const int side = sign(to.side);
    const Key target{to.pitches, side, side > 0 ? -m_rank : m_rank};
    if (from == nullptr) {
        yarn = {.open = true, .key = target, .number = openFloat()};
        return;
    }
    const int direction = target > yarn.key ? 1 : -1;
    const Key low = std::min(yarn.key, target);
    const Key high = std::max(yarn.key, target);
    m_met.clear();
    for (const Bed bed : kFrontBeds) {
        collectLoops(bed, low, high, 0);
    }
    for (const Bed bed : kRearBeds) {
        collectLoops(bed, low, high, m_emulator.state().rack);
    }
    // Carriers of one operation run side by side and do not pass each other.
    collectYarns(low, high, m_program.operations[static_cast<std::size_t>(operation())].carriers);
    sortMet(direction);
    for (const Met& met : m_met) {
        passFloat(carrier, met, direction);
    }
    yarn.key = target;
}

void StrandTracker::collectLoops(Bed bed, const Key& low, const Key& high, double rack) {
    const auto first = static_cast<std::int32_t>(std::floor(low.x - rack));
    const auto last = static_cast<std::int32_t>(std::ceil(high.x - rack));
    const machine::NeedleRow& row = m_emulator.state().beds[static_cast<std::size_t>(bed)];
    for (std::int32_t i = std::max(first, row.first()); i <= std::min(last, row.end() - 1); ++i) {
        const Key key{i + rack, 0, 0};
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
        if (yarn.open && !except.contains(static_cast<CarrierIndex>(c)) && low < yarn.key &&
            yarn.key < high) {
            const int rail = m_program.header.carriers[c].rail;
            m_met.push_back({yarn.key, {Strand::Kind::Float, yarn.number}, 0, rail});
        }
    }
}

void StrandTracker::sortMet(int direction) {
    std::stable_sort(m_met.begin(), m_met.end(), [direction](const Met& a, const Met& b) {
        return direction > 0 ? a.key < b.key : b.key < a.key;
    });
}

/// A yarn stands beside its needle.
double StrandTracker::placeOf(const Met& met) {
    return met.key.x + kBeside * met.key.side;
}

void StrandTracker::passFloat(CarrierIndex moving, const Met& met, int direction) {
    const Strand self{Strand::Kind::Float, m_yarns[moving].number};
    const bool selfInFront =
        met.layer < 0 || (met.layer == 0 && m_program.header.carriers[moving].rail <= met.rail);
    if (selfInFront) {
        pass(self, met.strand, direction, placeOf(met));
    } else {
        pass(met.strand, self, -direction, placeOf(met));
    }
}

void StrandTracker::loopMade(LoopIndex loop) {
    const machine::Loop& made = m_emulator.loops().loops[static_cast<std::size_t>(loop)];
    Yarn& yarn = m_yarns[made.carrier];
    m_fates.push_back({made.needle, made.rack, Loop::End::Held, isCrowded(made.needle, made.rack)});
    m_stay.push_back(++m_stayCount);
    m_openPassings.push_back(0);
    for (const LoopIndex parent : m_emulator.loops().parentsOf(loop)) {
        Fate& fate = m_fates[static_cast<std::size_t>(parent)];
        fate.end = Loop::End::Bound;
        if (made.kind == machine::OperationKind::Knit) {
            fate.needle = made.needle;
            fate.rack = made.rack;
        }
    }
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
        if (!moves.empty() && moves.back().fromFront != fromFront &&
            moves.back().openPassings == m_openPassings[i]) {
            m_stay[i] = moves.back().stayBefore; // came back unchanged: as if it had never left
            moves.pop_back();
        } else {
            moves.push_back({fromFront, m_stay[i], m_openPassings[i]});
            m_stay[i] = ++m_stayCount;
        }
    }
    forgetFacing(from);
}

void StrandTracker::loopsDropped(Needle needle, std::span<const LoopIndex> loops) {
    for (const LoopIndex loop : loops) {
        Fate& fate = m_fates[static_cast<std::size_t>(loop)];
        fate.needle = needle;
        fate.rack = m_emulator.state().rack;
        fate.end = fate.end == Loop::End::Bound ? fate.end : Loop::End::Dropped;
    }
    forgetFacing(needle);
}

void StrandTracker::yarnCut(CarrierIndex carrier) {
    m_yarns[carrier] = {};
}

bool StrandTracker::isCrowded(Needle needle, double rack) const {
    const bool front = machine::isFront(needle.bed);
    const double facing = front ? needle.index - rack : needle.index + rack;
    if (facing == std::floor(facing)) {
        return false; // face to face
    }
    return holdsLoop(!front, static_cast<std::int32_t>(std::floor(facing))) ||
           holdsLoop(!front, static_cast<std::int32_t>(std::ceil(facing)));
}

bool StrandTracker::holdsLoop(bool front, std::int32_t index) const {
    return std::ranges::any_of(front ? kFrontBeds : kRearBeds, [&](Bed bed) {
        return !m_emulator.state().loopsOn({bed, index}).empty();
    });
}

void StrandTracker::forgetFacing(Needle emptied) {
    const double rear =
        machine::isFront(emptied.bed) ? emptied.index - m_emulator.state().rack : emptied.index;
    m_facingFrom.erase(static_cast<std::int32_t>(std::lround(rear)));
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
    const Key low{rear + std::min(from, to), 0, 0};
    const Key high{rear + std::max(from, to), 0, 0};
    m_met.clear();
    for (const Bed bed : kFrontBeds) {
        collectLoops(bed, low, high, 0);
    }
    if (const auto facing = m_facingFrom.find(rear); facing != m_facingFrom.end()) {
        if (facing->second == -direction) {
            const Key here{rear + from, 0, 0};
            for (const Bed bed : kFrontBeds) {
                collectLoops(bed, {here.x, -1, 0}, {here.x, 1, 0}, 0);
            }
        }
        m_facingFrom.erase(facing);
    }
    collectYarns(low, high, {});
    sortMet(direction);
    for (const Met& met : m_met) {
        passRear(met, rear, direction);
    }
    const double end = rear + to;
    if (end == std::floor(end) && holdsLoop(true, static_cast<std::int32_t>(end))) {
        m_facingFrom[rear] = -direction;
    }
}

void StrandTracker::passRear(const Met& met, std::int32_t rear, int direction) {
    for (const Bed bed : kRearBeds) {
        for (const LoopIndex loop : m_emulator.state().loopsOn({bed, rear})) {
            pass(met.strand, {Strand::Kind::Loop, loop}, -direction, placeOf(met));
        }
    }
}

} // namespace knittsim::fabric
