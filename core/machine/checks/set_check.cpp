// Carriers that work together, and carriers that do not work at all.

#include "core/machine/checks/groups.h"

#include <algorithm>
#include <unordered_map>

namespace knittsim::machine {

namespace {

static_assert(kMaxCarriers <= 64, "a set of carriers fits a 64-bit mask");

class SetCheck : public CheckGroup {
public:
    SetCheck(const Timeline& timeline, Findings& findings)
        : CheckGroup(timeline, findings), m_broughtIn(m_program.header.carriers.size(), kNone),
          m_toldMissing(m_program.header.carriers.size(), false) {}

    void before(const Operation& op, const MachineState& state) override {
        switch (op.kind) {
        case OperationKind::In:
        case OperationKind::InHook:
            for (const CarrierIndex c : op.carriers) {
                checkName(c);
                m_broughtIn[c] = state.carriers[c].in ? m_broughtIn[c] : m_findings.operation();
            }
            break;
        case OperationKind::Out:
        case OperationKind::OutHook:
        case OperationKind::YarnOut:
            for (const CarrierIndex c : op.carriers) {
                checkUsed(c, state);
                m_broughtIn[c] = kNone;
            }
            break;
        default:
            if (makesLoop(op.kind)) {
                checkFirst(op, state);
                checkOrder(op);
            }
        }
    }

    void atEnd(const MachineState& state) override {
        for (std::size_t c = 0; c < state.carriers.size(); ++c) {
            checkUsed(static_cast<CarrierIndex>(c), state);
        }
    }

private:
    static constexpr OperationIndex kNone = -1;

    void checkName(CarrierIndex carrier) {
        const std::string& name = nameOf(carrier);
        if (!m_toldMissing[carrier] && std::ranges::count(m_profile.carriers, name) == 0) {
            m_toldMissing[carrier] = true;
            m_findings.report("KS0241", {name, m_profile.name});
        }
    }

    void checkUsed(CarrierIndex carrier, const MachineState& state) {
        if (m_broughtIn[carrier] != kNone && state.carriers[carrier].in && !state.carriers[carrier].looped) {
            m_findings.report("KS0238", {nameOf(carrier)}, {}, m_broughtIn[carrier]);
        }
    }

    void checkFirst(const Operation& op, const MachineState& state) {
        for (const CarrierIndex c : op.carriers) {
            if (state.carriers[c].looped || m_broughtIn[c] == kNone) {
                continue;
            }
            const CarrierSet& together =
                m_program.operations[static_cast<std::size_t>(m_broughtIn[c])].carriers;
            const bool same =
                together.size() == op.carriers.size() &&
                std::ranges::all_of(together, [&](CarrierIndex t) { return op.carriers.contains(t); });
            if (!same) {
                m_findings.report("KS0240", {nameOf(c), namesText(m_program, op.carriers)}, op.needle);
            }
        }
    }

    void checkOrder(const Operation& op) {
        if (op.carriers.size() < 2) {
            return;
        }
        std::uint64_t mask = 0;
        for (const CarrierIndex c : op.carriers) {
            mask |= std::uint64_t{1} << c;
        }
        const auto [known, added] = m_orders.try_emplace(mask, op.carriers);
        if (!added && known->second != op.carriers) {
            m_findings.report("KS0236",
                              {namesText(m_program, op.carriers), namesText(m_program, known->second)},
                              op.needle);
            known->second = op.carriers;
        }
    }

    std::vector<OperationIndex> m_broughtIn; ///< by carrier: the operation that brought it in, or kNone
    std::vector<bool> m_toldMissing;
    std::unordered_map<std::uint64_t, CarrierSet> m_orders; ///< by the set: its last order
};

} // namespace

std::unique_ptr<CheckGroup> makeSetCheck(const Timeline& timeline, Findings& findings) {
    return std::make_unique<SetCheck>(timeline, findings);
}

} // namespace knittsim::machine
