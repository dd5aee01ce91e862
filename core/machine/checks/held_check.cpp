// Loops that wait too long for their stitch. Counted are the yarns that pass a loop's needle while it waits,
// and those that turn just beside it.

#include "core/machine/checks/groups.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace knittsim::machine {

namespace {

/// How often each needle of a bed was passed: adds to a range and reads one needle in O(log needles)
/// (P. Fenwick 1994, here over differences).
class PassCounter {
public:
    void add(std::int32_t first, std::int32_t last) {
        if (first <= last) {
            put(first, 1);
            put(last + 1, -1);
        }
    }

    int at(std::int32_t needle) const {
        int sum = 0;
        for (std::size_t i = slot(needle); i > 0; i -= i & (~i + 1)) {
            sum += m_tree[i];
        }
        return sum;
    }

private:
    // Racking moves the rear bed at most this far beyond the needles that the emulator accepts.
    static constexpr std::int32_t kReach = kMaxNeedleIndex + 1100;
    static constexpr std::size_t kSlots = 2 * kReach + 3;

    static std::size_t slot(std::int32_t needle) {
        return static_cast<std::size_t>(std::clamp(needle, -kReach, kReach) + kReach + 1);
    }

    void put(std::int32_t needle, int value) {
        for (std::size_t i = slot(needle); i < m_tree.size(); i += i & (~i + 1)) {
            m_tree[i] += value;
        }
    }

    std::vector<int> m_tree = std::vector<int>(kSlots + 1, 0);
};

class HeldCheck : public CheckGroup {
public:
    HeldCheck(const Timeline& timeline, Findings& findings)
        : CheckGroup(timeline, findings), m_waits(m_loops.loops.size()) {}

    void before(const Operation& op, const MachineState& state) override {
        m_op = &op;
        m_rack = state.rack;
    }

    void yarnMoved(CarrierIndex carrier, const CarrierPlace* from, const CarrierPlace& to) override {
        if (from == nullptr || carrier != m_op->carriers[0]) {
            return; // yarns that run together pass once
        }
        // From behind the last needle up to this one; a turn also tugs at the needle that it spares.
        const double a = from->pitches;
        const double b = to.pitches;
        const bool turned = from->side != m_op->direction;
        for (const bool front : {true, false}) {
            const double shift = front ? 0 : m_rack;
            PassCounter& passes = front ? m_front : m_rear;
            if (turned) {
                const double spared = a - shift + sign(from->side);
                const auto needle = static_cast<std::int32_t>(std::lround(spared));
                passes.add(needle, needle);
            }
            if (b > a) {
                passes.add(static_cast<std::int32_t>(std::floor(a - shift)) + 1,
                           static_cast<std::int32_t>(std::floor(b - shift)));
            } else {
                passes.add(static_cast<std::int32_t>(std::ceil(b - shift)),
                           static_cast<std::int32_t>(std::ceil(a - shift)) - 1);
            }
        }
    }

    void loopMade(LoopIndex loop) override {
        const Loop& made = loopAt(loop);
        for (const LoopIndex parent : m_loops.parentsOf(loop)) {
            checkEnd(parent, made.needle, made.kind == OperationKind::Split);
        }
        waitsOf(loop) = {0, counterAt(made.needle)};
    }

    void loopsMoved(Needle from, Needle to, std::span<const LoopIndex> loops) override {
        for (const LoopIndex loop : loops) {
            Waits& waits = waitsOf(loop);
            waits.passes += counterAt(from) - waits.base;
            waits.base = counterAt(to);
        }
    }

private:
    struct Waits {
        int passes = 0; ///< on needles before the present one
        int base = 0;   ///< counter of the present needle when the loop came there
        bool told = false;
    };

    Waits& waitsOf(LoopIndex loop) { return m_waits[static_cast<std::size_t>(loop)]; }

    int counterAt(Needle needle) const { return (isFront(needle.bed) ? m_front : m_rear).at(needle.index); }

    void checkEnd(LoopIndex loop, Needle needle, bool moved) {
        Waits& waits = waitsOf(loop);
        // The yarn that makes the stitch has just come to the needle; it is no pass.
        const int passes = waits.passes + (moved ? 0 : counterAt(needle) - waits.base) - 1;
        if (passes > m_profile.limits.heldPasses && !waits.told) {
            waits.told = true; // plated loops come through it one by one
            const Operation& maker = m_program.operations[static_cast<std::size_t>(loopAt(loop).operation)];
            m_findings.report("KS0232",
                              {toString(needle), std::to_string(maker.line), std::to_string(passes),
                               std::to_string(m_profile.limits.heldPasses)},
                              needle);
        }
    }

    std::vector<Waits> m_waits; ///< by loop
    PassCounter m_front;
    PassCounter m_rear;
    const Operation* m_op = nullptr; ///< the present one
    double m_rack = 0;
};

} // namespace

std::unique_ptr<CheckGroup> makeHeldCheck(const Timeline& timeline, Findings& findings) {
    return std::make_unique<HeldCheck>(timeline, findings);
}

} // namespace knittsim::machine
