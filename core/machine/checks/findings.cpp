#include "core/machine/checks/findings.h"

#include "core/machine/checks/rules.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <utility>

namespace knittsim::machine {

void Findings::report(std::string_view rule, std::vector<std::string> arguments, std::optional<Needle> needle,
                      OperationIndex operation) {
    const Rule* known = findRule(rule);
    assert(known != nullptr);
    if (m_kept[known->id].count++ >= kMaxFindingsOfRule) {
        return;
    }
    const OperationIndex at = operation >= 0 ? operation : m_operation;
    Place place{.file = m_program.file, .operation = at};
    if (static_cast<std::size_t>(at) < m_program.operations.size()) {
        place.line = m_program.operations[static_cast<std::size_t>(at)].line;
    } else {
        place.operation = -1;
    }
    if (needle) {
        place.needle = toString(*needle);
    }
    m_findings.push_back({std::string(rule), known->severity, std::move(place), std::move(arguments)});
}

void Findings::reportRun(std::string_view rule, std::vector<std::string> arguments, Needle needle) {
    Kept& kept = m_kept[rule];
    if (kept.last + 1 == m_operation) {
        kept.last = m_operation;
        ++kept.runLength;
        if (kept.runListed) {
            m_findings[kept.runFinding].arguments.back() = std::to_string(kept.runLength) + " in a row";
        }
        return;
    }
    kept.last = m_operation;
    kept.runLength = 1;
    kept.runListed = kept.count < kMaxFindingsOfRule;
    kept.runFinding = m_findings.size();
    arguments.emplace_back("once");
    report(rule, std::move(arguments), needle);
}

Diagnostics Findings::take() {
    for (const auto& [rule, kept] : m_kept) {
        if (kept.count > kMaxFindingsOfRule) {
            m_findings.push_back({"KS0243",
                                  Severity::Info,
                                  Place{.file = m_program.file},
                                  {std::to_string(kept.count - kMaxFindingsOfRule), std::string(rule)}});
        }
    }
    m_kept.clear();
    return std::exchange(m_findings, {});
}

void sortByOperation(Diagnostics& findings) {
    std::ranges::stable_sort(findings, {}, [](const Diagnostic& found) {
        return found.place.operation < 0 ? std::numeric_limits<int>::max() : found.place.operation;
    });
}

} // namespace knittsim::machine
