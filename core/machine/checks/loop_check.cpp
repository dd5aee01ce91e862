// Loops on needles: made on nothing, piled up, dropped, left behind.

#include "core/machine/checks/groups.h"

#include <fmt/format.h>

#include <algorithm>

namespace knittsim::machine {

namespace {

class LoopCheck : public CheckGroup {
public:
    LoopCheck(const Timeline& timeline, Findings& findings)
        : CheckGroup(timeline, findings), m_holders(m_loops.loops.size(), 0),
          m_onNeedle(m_loops.loops.size(), false), m_gone(m_loops.loops.size(), false) {}

    void before(const Operation& op, const MachineState& state) override {
        if (op.kind != OperationKind::Drop) {
            reportDrops();
        }
        const bool draws = op.kind == OperationKind::Knit || op.kind == OperationKind::Split;
        if (draws && state.loopsOn(op.needle).empty()) {
            m_findings.reportRun("KS0228", {toString(op.needle)}, op.needle);
        }
    }

    void after(const Operation& op, const MachineState& state) override {
        if (makesLoop(op.kind)) {
            checkCount(op.needle, state);
        }
        if (op.kind == OperationKind::Xfer || op.kind == OperationKind::Split) {
            checkCount(op.target, state);
        }
        if (op.kind == OperationKind::Tuck) {
            checkTucks(op.needle, state);
        }
    }

    void loopMade(LoopIndex loop) override {
        const bool stay = loopAt(loop).kind == OperationKind::Split;
        for (const LoopIndex parent : m_loops.parentsOf(loop)) {
            ++m_holders[static_cast<std::size_t>(parent)];
            m_onNeedle[static_cast<std::size_t>(parent)] = stay;
        }
        m_onNeedle[static_cast<std::size_t>(loop)] = true;
    }

    void loopsDropped(Needle needle, std::span<const LoopIndex> loops) override {
        if (m_droppedLoops == 0) {
            m_dropOperation = m_findings.operation();
            m_dropNeedle = needle;
        }
        m_droppedLoops += loops.size();
        for (const LoopIndex loop : loops) {
            m_onNeedle[static_cast<std::size_t>(loop)] = false;
            run(loop);
        }
    }

    void atEnd(const MachineState& state) override {
        reportDrops();
        std::size_t left = 0;
        std::vector<Needle> needles;
        for (std::size_t b = 0; b < state.beds.size(); ++b) {
            const NeedleRow& row = state.beds[b];
            for (std::int32_t i = row.first(); i < row.end(); ++i) {
                if (!row.at(i).empty()) {
                    left += row.at(i).size();
                    needles.push_back({static_cast<Bed>(b), i});
                }
            }
        }
        if (left > 0) {
            m_findings.report("KS0230",
                              {loopsText(left), toString(needles.front()), toString(needles.back())},
                              needles.front());
        }
    }

private:
    /// A loop that no needle and no loop holds lets those run that it was drawn through.
    void run(LoopIndex first) {
        m_toRun.assign(1, first);
        while (!m_toRun.empty()) {
            const LoopIndex loop = m_toRun.back();
            m_toRun.pop_back();
            const auto i = static_cast<std::size_t>(loop);
            if (m_holders[i] > 0 || m_onNeedle[i] || m_gone[i]) {
                continue;
            }
            m_gone[i] = true;
            ++m_runs;
            for (const LoopIndex parent : m_loops.parentsOf(loop)) {
                --m_holders[static_cast<std::size_t>(parent)];
                m_toRun.push_back(parent);
            }
        }
    }

    void reportDrops() {
        if (m_runs > 0) {
            m_findings.report("KS0229",
                              {toString(m_dropNeedle), loopsText(m_droppedLoops), std::to_string(m_runs)},
                              m_dropNeedle, m_dropOperation);
        }
        m_droppedLoops = 0;
        m_runs = 0;
    }

    void checkCount(Needle needle, const MachineState& state) {
        const std::size_t count = state.loopsOn(needle).size();
        if (count > static_cast<std::size_t>(m_profile.maxLoopsOnNeedle)) {
            m_findings.report(
                "KS0231",
                {toString(needle), std::to_string(count), std::to_string(m_profile.maxLoopsOnNeedle)},
                needle);
        }
    }

    void checkTucks(Needle needle, const MachineState& state) {
        const std::span<const LoopIndex> loops = state.loopsOn(needle);
        const int most = m_profile.limits.tucksOnNeedle;
        int tucks = 0;
        OperationIndex last = -1;
        for (auto loop = loops.rbegin(); loop != loops.rend() && tucks <= most; ++loop) {
            const Loop& made = loopAt(*loop);
            tucks += made.kind == OperationKind::Tuck && made.operation != last ? 1 : 0;
            last = made.operation;
        }
        if (tucks > most) {
            m_findings.report("KS0234", {toString(needle), fmt::format("{}", tucks), fmt::format("{}", most)},
                              needle);
        }
    }

    std::vector<std::int32_t> m_holders; ///< by loop: loops drawn through it that hold
    std::vector<bool> m_onNeedle;        ///< by loop
    std::vector<bool> m_gone;            ///< by loop: has run
    std::vector<LoopIndex> m_toRun;
    std::size_t m_runs = 0;         ///< stitches that the present row of drops lets run
    std::size_t m_droppedLoops = 0; ///< by the present row of drops
    OperationIndex m_dropOperation = 0;
    Needle m_dropNeedle;
};

} // namespace

std::unique_ptr<CheckGroup> makeLoopCheck(const Timeline& timeline, Findings& findings) {
    return std::make_unique<LoopCheck>(timeline, findings);
}

} // namespace knittsim::machine
