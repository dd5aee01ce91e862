#pragma once

#include "core/formats/knitout/writer.h"
#include "core/machine/timeline.h"
#include "core/pattern/compile.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

/// Helpers of the pattern tests: charts from letters, programs as lines of knitout, loops by operation.
namespace knittsim::pattern {

/// Rows from the top course down, one letter a wale: k p b t m r . (Stitch in the order of its definition).
/// An upper-case letter is knitted with yarn 1 instead of yarn 0. Yarns use carriers 1 and 2.
inline Chart chartOf(const std::vector<std::string>& rows) {
    static const std::string kLetters = "kpbtmr.";
    Chart chart(static_cast<int>(rows.front().size()), static_cast<int>(rows.size()));
    chart.yarns = {{"1", {}, ""}, {"2", {}, ""}};
    for (int course = 0; course < chart.height(); ++course) {
        const std::string& row = rows[rows.size() - 1 - static_cast<std::size_t>(course)];
        for (int wale = 0; wale < chart.width; ++wale) {
            const char letter = row[static_cast<std::size_t>(wale)];
            const bool upper = letter >= 'A' && letter <= 'Z';
            const char lower = upper ? static_cast<char>(letter - 'A' + 'a') : letter;
            chart.at(wale, course) = {static_cast<Stitch>(kLetters.find(lower)),
                                      static_cast<std::uint8_t>(upper)};
        }
    }
    return chart;
}

inline machine::Program compiled(const Chart& chart,
                                 const CompileOptions& options = {.castOn = CastOn::Open}) {
    const Result<machine::Program> result = compile(chart, options);
    EXPECT_TRUE(result) << (result.diagnostics().empty() ? "" : result.diagnostics()[0].id);
    return result ? result.value() : machine::Program{};
}

/// Operations as knitout lines, without header, colours and carriers coming and going.
inline std::vector<std::string> linesOf(const machine::Program& program) {
    std::vector<std::string> lines;
    std::istringstream text(formats::knitout::write(program));
    for (std::string line; std::getline(text, line);) {
        const bool kept = line[0] != ';' && line.rfind("x-vis", 0) != 0 && line.rfind("in", 0) != 0 &&
                          line.rfind("out", 0) != 0 && line.rfind("release", 0) != 0;
        if (kept) {
            lines.push_back(line);
        }
    }
    return lines;
}

/// The program on the generic machine; expects that the machine finds nothing wrong.
inline machine::Timeline knitted(const machine::Program& program) {
    machine::Timeline timeline(program, machine::genericProfile());
    for (const Diagnostic& diagnostic : timeline.diagnostics()) {
        ADD_FAILURE() << diagnostic.id << " at operation " << diagnostic.place.operation;
    }
    return timeline;
}

inline int count(const machine::Program& program, machine::OperationKind kind) {
    return static_cast<int>(std::ranges::count(program.operations, kind, &machine::Operation::kind));
}

} // namespace knittsim::pattern
