#pragma once

#include "core/base/diagnostic.h"
#include "core/machine/program.h"

#include <map>
#include <optional>
#include <string_view>
#include <vector>

namespace knittsim::machine {

/// Gathers what the checks find. Each rule lists a bounded number of findings.
class Findings {
public:
    explicit Findings(const Program& program) : m_program(program) {}

    /// Findings belong to this operation from now on.
    void setOperation(OperationIndex operation) { m_operation = operation; }
    OperationIndex operation() const { return m_operation; }

    /// At the present operation, or at `operation`.
    void report(std::string_view rule, std::vector<std::string> arguments,
                std::optional<Needle> needle = std::nullopt, OperationIndex operation = -1);

    /// Findings of one rule at operations that follow each other become one, at the first of them.
    /// `arguments` are those of the first; "once" or "5 in a row" is added as the last one.
    void reportRun(std::string_view rule, std::vector<std::string> arguments, Needle needle);

    /// All findings. Leaves nothing behind.
    Diagnostics take();

private:
    struct Kept {
        std::size_t count = 0;      ///< findings of this rule, listed or not
        OperationIndex last = -2;   ///< operation of the last one that was counted into a run
        std::size_t runLength = 0;  ///< operations of that run
        std::size_t runFinding = 0; ///< its place in m_findings
        bool runListed = false;
    };

    const Program& m_program;
    OperationIndex m_operation = 0;
    Diagnostics m_findings;
    std::map<std::string_view, Kept> m_kept; ///< by rule
};

/// Puts findings into the order of the program; those without an operation come last.
void sortByOperation(Diagnostics& findings);

/// Findings of one rule that are listed.
constexpr std::size_t kMaxFindingsOfRule = 500;

} // namespace knittsim::machine
