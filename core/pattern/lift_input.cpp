#include "core/pattern/lift_input.h"

#include "core/pattern/program_course.h"
#include "core/pattern/project.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>

namespace knittsim::pattern {

using machine::CarrierIndex;
using machine::Operation;
using machine::OperationKind;

namespace {

class Preparation {
public:
    Preparation(const machine::Program& program, const machine::MachineProfile& machine,
                const std::vector<machine::CarrierYarn>& yarns)
        : m_program(program), m_machine(machine), m_yarns(yarns) {
        m_yarnOf.fill(-1);
    }

    Result<LiftInput> run() {
        m_input.texts = &m_program.texts;
        takeOperations();
        if (!m_worked) {
            return problem("KS0512", {});
        }
        if (m_input.yarns.size() > kMaxChartYarns) {
            return problem("KS0514", {std::to_string(m_input.yarns.size()), std::to_string(kMaxChartYarns)});
        }
        if (m_last - m_first >= kMaxWales) {
            return problem("KS0510",
                           {fmt::format("{} wales", m_last - m_first + 1), fmt::format("{}", kMaxWales)});
        }
        m_input.firstNeedle = m_first;
        m_input.wales = m_last - m_first + 1;
        for (Operation& op : m_input.operations) {
            op.needle.index -= namesNeedle(op.kind) ? m_first : 0;
            op.target.index -= namesTarget(op.kind) ? m_first : 0;
        }
        return findCarriers();
    }

private:
    Diagnostic problem(const char* id, std::vector<std::string> arguments) const {
        return {id, Severity::Error, Place{.file = m_program.file}, std::move(arguments)};
    }

    CarrierIndex yarnOf(CarrierIndex carrier) {
        int& yarn = m_yarnOf[carrier];
        if (yarn < 0) {
            yarn = static_cast<int>(m_input.yarns.size());
            const machine::Carrier& own = m_program.header.carriers[carrier];
            const yarn::Colour colour =
                carrier < m_yarns.size() ? m_yarns[carrier].yarn.colour : yarn::Colour{};
            m_input.yarns.push_back({own.name, colour, own.yarn});
        }
        return static_cast<CarrierIndex>(yarn);
    }

    void takeOperations() {
        double rack = 0;
        double number = -1;
        for (const Operation& op : m_program.operations) {
            Operation taken = op;
            taken.line = -1;
            taken.carriers = {};
            for (const CarrierIndex carrier : op.carriers) {
                taken.carriers.push(yarnOf(carrier));
            }
            m_worked = m_worked || machine::carriesYarn(op.kind);
            if ((op.kind == OperationKind::Colour && !m_worked) || sets(op, OperationKind::Rack, rack) ||
                sets(op, OperationKind::StitchNumber, number)) {
                continue;
            }
            number = op.kind == OperationKind::StitchSize ? -1 : number;
            span(taken);
            m_input.operations.push_back(taken);
        }
    }

    /// Something to what it is already; else it is that from now on.
    static bool sets(const Operation& op, OperationKind kind, double& value) {
        if (op.kind != kind) {
            return false;
        }
        const bool same = op.value == value;
        value = op.value;
        return same;
    }

    void span(const Operation& op) {
        const auto take = [&](int index) {
            m_first = std::min(m_first, index);
            m_last = std::max(m_last, index);
        };
        if (namesNeedle(op.kind)) {
            take(op.needle.index);
        }
        if (namesTarget(op.kind)) {
            take(op.target.index);
        }
    }

    /// Carriers that the machine has not get one of those that are left.
    Result<LiftInput> findCarriers() {
        const std::vector<std::string>& names = m_machine.carriers;
        const auto has = [&](const std::string& name) {
            return std::ranges::find(names, name) != names.end();
        };
        for (ChartYarn& yarn : m_input.yarns) {
            if (has(yarn.carrier)) {
                continue;
            }
            const auto isFree = [&](const std::string& name) {
                return std::ranges::find(m_input.yarns, name, &ChartYarn::carrier) == m_input.yarns.end();
            };
            const auto other = std::ranges::find_if(names, isFree);
            if (other == names.end()) {
                return problem("KS0515", {yarn.carrier, m_machine.name});
            }
            m_input.notes.push_back(
                {"KS0513", Severity::Warning, Place{.file = m_program.file}, {yarn.carrier, *other}});
            yarn.carrier = *other;
        }
        return std::move(m_input);
    }

    const machine::Program& m_program;
    const machine::MachineProfile& m_machine;
    const std::vector<machine::CarrierYarn>& m_yarns;
    LiftInput m_input;
    std::array<int, 256> m_yarnOf{}; ///< by carrier; -1: none yet
    bool m_worked = false;           ///< a carrier has
    int m_first = std::numeric_limits<int>::max();
    int m_last = std::numeric_limits<int>::min();
};

} // namespace

Result<LiftInput> liftInput(const machine::Program& program, const machine::MachineProfile& machine,
                            const std::vector<machine::CarrierYarn>& yarns) {
    return Preparation(program, machine, yarns).run();
}

} // namespace knittsim::pattern
