// Two neighbouring loops of one yarn that transfers and racks pull apart. Between their needles lies half of
// each loop and the float between them; what more the way needs must come out of the loops beside them.

#include "core/machine/checks/groups.h"

#include <fmt/format.h>

#include <cmath>
#include <optional>

namespace knittsim::machine {

namespace {

constexpr LoopIndex kNone = -1;

class StretchCheck : public CheckGroup {
public:
    StretchCheck(const Timeline& timeline, Findings& findings)
        : CheckGroup(timeline, findings), m_before(m_loops.loops.size(), kNone),
          m_after(m_loops.loops.size(), kNone), m_needle(m_loops.loops.size()),
          m_told(m_loops.loops.size(), false) {
        std::vector<LoopIndex> last;
        for (std::size_t i = 0; i < m_loops.loops.size(); ++i) {
            const auto yarn = static_cast<std::size_t>(m_loops.loops[i].yarn);
            if (yarn >= last.size()) {
                last.resize(yarn + 1, kNone);
            }
            m_before[i] = last[yarn];
            if (last[yarn] != kNone) {
                m_after[static_cast<std::size_t>(last[yarn])] = static_cast<LoopIndex>(i);
            }
            last[yarn] = static_cast<LoopIndex>(i);
        }
    }

    void loopMade(LoopIndex loop) override {
        const Loop& made = loopAt(loop);
        for (const LoopIndex parent : m_loops.parentsOf(loop)) {
            if (made.kind != OperationKind::Split) {
                leave(parent);
            }
        }
        needleOf(loop) = made.needle;
        m_rear += isFront(made.needle.bed) ? 0 : 1;
    }

    void loopsMoved(Needle from, Needle to, std::span<const LoopIndex> loops) override {
        for (const LoopIndex loop : loops) {
            needleOf(loop) = to;
            m_moved.push_back(loop);
        }
        const auto count = static_cast<std::int64_t>(loops.size());
        m_rear += isFront(from.bed) == isFront(to.bed) ? 0 : isFront(to.bed) ? -count : count;
    }

    void loopsDropped(Needle, std::span<const LoopIndex> loops) override {
        for (const LoopIndex loop : loops) {
            leave(loop);
        }
    }

    void after(const Operation& op, const MachineState& state) override {
        if (op.kind == OperationKind::Rack && m_rear > 0) {
            for (const Bed bed : {Bed::Rear, Bed::RearSlider}) {
                const NeedleRow& row = state.beds[static_cast<std::size_t>(bed)];
                for (std::int32_t i = row.first(); i < row.end(); ++i) {
                    for (const LoopIndex loop : row.at(i)) {
                        checkBoth(loop, state.rack);
                    }
                }
            }
        }
        for (const LoopIndex loop : m_moved) {
            checkBoth(loop, state.rack);
        }
        m_moved.clear();
    }

private:
    std::optional<Needle>& needleOf(LoopIndex loop) { return m_needle[static_cast<std::size_t>(loop)]; }

    void leave(LoopIndex loop) {
        if (needleOf(loop) && !isFront(needleOf(loop)->bed)) {
            --m_rear;
        }
        needleOf(loop).reset();
    }

    void checkBoth(LoopIndex loop, double rack) {
        checkPair(m_before[static_cast<std::size_t>(loop)], loop, rack);
        checkPair(loop, m_after[static_cast<std::size_t>(loop)], rack);
    }

    void checkPair(LoopIndex a, LoopIndex b, double rack) {
        if (a == kNone || b == kNone || m_told[static_cast<std::size_t>(b)] || !needleOf(a) || !needleOf(b)) {
            return;
        }
        const Needle from = *needleOf(a);
        const Needle to = *needleOf(b);
        const double along = (positionPitches(to, rack) - positionPitches(from, rack)) * m_profile.pitchMm();
        const double way = std::hypot(along, isFront(from.bed) == isFront(to.bed) ? 0.0 : m_profile.bedGapMm);
        const double yarn = (loopAt(a).lengthMm + loopAt(b).lengthMm) / 2 + loopAt(b).floatMm;
        if (way > yarn * m_profile.limits.stretch) {
            m_told[static_cast<std::size_t>(b)] = true;
            m_findings.report(
                "KS0235",
                {toString(from), toString(to), fmt::format("{:.1f}", way), fmt::format("{:.1f}", yarn)},
                from);
        }
    }

    std::vector<LoopIndex> m_before; ///< by loop: the one before it on its yarn
    std::vector<LoopIndex> m_after;
    std::vector<std::optional<Needle>> m_needle; ///< by loop: where it hangs
    std::vector<bool> m_told;                    ///< by the second loop of a pair
    std::vector<LoopIndex> m_moved;              ///< by the present operation
    std::int64_t m_rear = 0;                     ///< loops on the rear bed
};

} // namespace

std::unique_ptr<CheckGroup> makeStretchCheck(const Timeline& timeline, Findings& findings) {
    return std::make_unique<StretchCheck>(timeline, findings);
}

} // namespace knittsim::machine
