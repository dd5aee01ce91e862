// The yarn inserting hook: it brings a yarn in from the right, waits beside the first stitch, and must let go
// before it can do anything else.

#include "core/machine/checks/groups.h"

#include <optional>

namespace knittsim::machine {

namespace {

class HookCheck : public CheckGroup {
public:
    using CheckGroup::CheckGroup;

    void before(const Operation& op, const MachineState& state) override {
        switch (op.kind) {
        case OperationKind::InHook:
            checkMachine();
            m_inHook = m_findings.operation();
            m_waitsAt.reset();
            m_takenOut = false;
            break;
        case OperationKind::OutHook:
            checkMachine();
            break;
        case OperationKind::ReleaseHook:
            checkRelease(op, state);
            m_waitsAt.reset();
            break;
        case OperationKind::Out:
        case OperationKind::YarnOut:
            checkOut(op, state);
            break;
        default:
            if (m_profile.hookBlocksNeedles > 0 && !state.hook.empty()) {
                checkNeedle(op, state);
            }
        }
    }

    void atEnd(const MachineState& state) override {
        if (!state.hook.empty() && !m_takenOut) {
            m_findings.report("KS0212", {nameOf(state.hook[0])}, {}, m_inHook);
        }
    }

private:
    void checkMachine() {
        if (!m_profile.insertingHook && !m_toldMachine) {
            m_toldMachine = true;
            m_findings.report("KS0215", {m_profile.name});
        }
    }

    void checkRelease(const Operation& op, const MachineState& state) {
        for (const CarrierIndex c : op.carriers) {
            if (state.hook.contains(c) && !state.carriers[c].looped) {
                m_findings.report("KS0214", {nameOf(c)});
                return;
            }
        }
    }

    void checkOut(const Operation& op, const MachineState& state) {
        for (const CarrierIndex c : op.carriers) {
            if (state.hook.contains(c)) {
                m_findings.report("KS0213", {nameOf(c)});
                m_takenOut = true;
                return;
            }
        }
    }

    void checkNeedle(const Operation& op, const MachineState& state) {
        const bool works =
            carriesYarn(op.kind) || op.kind == OperationKind::Xfer || op.kind == OperationKind::Drop;
        if (!works) {
            return;
        }
        const double at = positionPitches(op.needle, state.rack);
        if (!m_waitsAt) {
            if (makesLoop(op.kind) && op.carriers.contains(state.hook[0])) {
                m_waitsAt = at;
                m_first = op.needle;
                if (op.direction == Direction::Right) {
                    m_findings.report("KS0216", {nameOf(state.hook[0])}, op.needle);
                }
            }
            return;
        }
        if (at > *m_waitsAt && at <= *m_waitsAt + m_profile.hookBlocksNeedles) {
            m_findings.report("KS0217", {toString(op.needle), toString(m_first), nameOf(state.hook[0])},
                              op.needle);
        }
    }

    OperationIndex m_inHook = 0;     ///< the last inhook
    std::optional<double> m_waitsAt; ///< pitches, since its first stitch
    Needle m_first;                  ///< of that stitch
    bool m_takenOut = false;         ///< its carrier was taken out, which is said already
    bool m_toldMachine = false;
};

} // namespace

std::unique_ptr<CheckGroup> makeHookCheck(const Timeline& timeline, Findings& findings) {
    return std::make_unique<HookCheck>(timeline, findings);
}

} // namespace knittsim::machine
