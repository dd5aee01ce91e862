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
          m_told(m_loops.loops.size(), false), m_acrossAt(m_loops.loops.size(), kNone) {
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
                hang(parent, std::nullopt);
            }
        }
        hang(loop, made.needle);
    }

    void loopsMoved(Needle, Needle to, std::span<const LoopIndex> loops) override {
        for (const LoopIndex loop : loops) {
            hang(loop, to);
            m_moved.push_back(loop);
        }
    }

    void loopsDropped(Needle, std::span<const LoopIndex> loops) override {
        for (const LoopIndex loop : loops) {
            hang(loop, std::nullopt);
        }
    }

    void after(const Operation& op, const MachineState& state) override {
        if (op.kind == OperationKind::Rack) {
            for (const LoopIndex second : m_across) {
                checkPair(second, state.rack);
            }
        }
        for (const LoopIndex loop : m_moved) {
            checkPair(loop, state.rack);
            checkPair(m_after[static_cast<std::size_t>(loop)], state.rack);
        }
        m_moved.clear();
    }

private:
    std::optional<Needle>& needleOf(LoopIndex loop) { return m_needle[static_cast<std::size_t>(loop)]; }

    void hang(LoopIndex loop, std::optional<Needle> needle) {
        needleOf(loop) = needle;
        sortOut(loop);
        sortOut(m_after[static_cast<std::size_t>(loop)]);
    }

    /// A rack pulls only at pairs from bed to bed: keeps them in m_across.
    void sortOut(LoopIndex second) {
        if (second == kNone) {
            return;
        }
        const LoopIndex first = m_before[static_cast<std::size_t>(second)];
        const bool across = first != kNone && needleOf(first) && needleOf(second) &&
                            isFront(needleOf(first)->bed) != isFront(needleOf(second)->bed);
        std::int32_t& at = m_acrossAt[static_cast<std::size_t>(second)];
        if (across && at == kNone) {
            at = static_cast<std::int32_t>(m_across.size());
            m_across.push_back(second);
        } else if (!across && at != kNone) {
            m_acrossAt[static_cast<std::size_t>(m_across.back())] = at;
            m_across[static_cast<std::size_t>(at)] = m_across.back();
            m_across.pop_back();
            at = kNone;
        }
    }

    void checkPair(LoopIndex b, double rack) {
        if (b == kNone || m_told[static_cast<std::size_t>(b)]) {
            return;
        }
        const LoopIndex a = m_before[static_cast<std::size_t>(b)];
        if (a == kNone || !needleOf(a) || !needleOf(b)) {
            return;
        }
        const Needle from = *needleOf(a);
        const Needle to = *needleOf(b);
        const double along = (positionPitches(to, rack) - positionPitches(from, rack)) * m_profile.pitchMm();
        const double across = isFront(from.bed) == isFront(to.bed) ? 0.0 : m_profile.bedGapMm;
        const double yarn = (loopAt(a).lengthMm + loopAt(b).lengthMm) / 2 + loopAt(b).floatMm;
        const double longest = yarn * m_profile.limits.stretch;
        // Squares: a rack asks this of every pair from bed to bed.
        if (along * along + across * across > longest * longest) {
            m_told[static_cast<std::size_t>(b)] = true;
            m_findings.report("KS0235",
                              {toString(from), toString(to), fmt::format("{:.1f}", std::hypot(along, across)),
                               fmt::format("{:.1f}", yarn)},
                              from);
        }
    }

    std::vector<LoopIndex> m_before; ///< by loop: the one before it on its yarn
    std::vector<LoopIndex> m_after;
    std::vector<std::optional<Needle>> m_needle; ///< by loop: where it hangs
    std::vector<bool> m_told;                    ///< by the second loop of a pair
    std::vector<LoopIndex> m_moved;              ///< by the present operation
    std::vector<LoopIndex> m_across;             ///< second loops of pairs from bed to bed
    std::vector<std::int32_t> m_acrossAt;        ///< by second loop: its place in m_across, or kNone
};

} // namespace

std::unique_ptr<CheckGroup> makeStretchCheck(const Timeline& timeline, Findings& findings) {
    return std::make_unique<StretchCheck>(timeline, findings);
}

} // namespace knittsim::machine
