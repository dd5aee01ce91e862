#include "tests/support/same_meaning.h"

#include "core/machine/timeline.h"

#include <algorithm>
#include <map>

namespace knittsim::test {

using machine::Bed;
using machine::Loop;
using machine::LoopIndex;
using machine::Needle;
using machine::Timeline;

namespace {

const std::string& carrierName(const Timeline& timeline, const Loop& loop) {
    return timeline.program().header.carriers[loop.carrier].name;
}

bool sameLoop(const Timeline& a, const Timeline& b, LoopIndex index, int shift) {
    const Loop& x = a.loops().loops[static_cast<std::size_t>(index)];
    const Loop& y = b.loops().loops[static_cast<std::size_t>(index)];
    const auto parentsX = a.loops().parentsOf(index);
    const auto parentsY = b.loops().parentsOf(index);
    return x.kind == y.kind && x.direction == y.direction && x.needle.bed == y.needle.bed &&
           x.needle.index + shift == y.needle.index && carrierName(a, x) == carrierName(b, y) &&
           std::equal(parentsX.begin(), parentsX.end(), parentsY.begin(), parentsY.end());
}

/// Yarns are counted as they come in; the same yarns may come in in another order.
class YarnPairs {
public:
    bool fit(const Loop& x, const Loop& y) {
        return m_forth.emplace(x.yarn, y.yarn).first->second == y.yarn &&
               m_back.emplace(y.yarn, x.yarn).first->second == x.yarn;
    }

private:
    std::map<std::int32_t, std::int32_t> m_forth;
    std::map<std::int32_t, std::int32_t> m_back;
};

std::string describe(const Timeline& timeline, LoopIndex index) {
    const Loop& loop = timeline.loops().loops[static_cast<std::size_t>(index)];
    return std::string(machine::toString(loop.kind)) +
           (loop.direction == machine::Direction::Right ? " + " : " - ") + machine::toString(loop.needle) +
           ' ' + carrierName(timeline, loop) + " of line " +
           std::to_string(timeline.program().operations[static_cast<std::size_t>(loop.operation)].line);
}

} // namespace

std::string differenceInMeaning(const machine::Program& first, const machine::Program& second, int shift) {
    const Timeline a(first, machine::genericProfile());
    const Timeline b(second, machine::genericProfile());
    const auto countA = static_cast<LoopIndex>(a.loops().loops.size());
    const auto countB = static_cast<LoopIndex>(b.loops().loops.size());
    YarnPairs yarns;
    for (LoopIndex i = 0; i < std::min(countA, countB); ++i) {
        const auto index = static_cast<std::size_t>(i);
        if (!sameLoop(a, b, i, shift) || !yarns.fit(a.loops().loops[index], b.loops().loops[index])) {
            return "loop " + std::to_string(i) + ": " + describe(a, i) + ", " + describe(b, i);
        }
    }
    if (countA != countB) {
        return std::to_string(countA) + " and " + std::to_string(countB) + " loops";
    }
    const auto endA = a.finalState();
    const auto endB = b.finalState();
    for (int bed = 0; bed < machine::kBedCount; ++bed) {
        for (int index = -machine::kMaxNeedleIndex; index <= machine::kMaxNeedleIndex; ++index) {
            const auto held = endA.loopsOn({static_cast<Bed>(bed), index});
            const auto other = endB.loopsOn({static_cast<Bed>(bed), index + shift});
            if (!std::equal(held.begin(), held.end(), other.begin(), other.end())) {
                return "at the end the loops on " + machine::toString(Needle{static_cast<Bed>(bed), index}) +
                       " differ";
            }
        }
    }
    return {};
}

} // namespace knittsim::test
