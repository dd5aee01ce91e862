#include "ui/document/problem_marks.h"

#include "ui/document/selection.h"

#include <algorithm>

namespace knittsim::document {

namespace {

using machine::LoopIndex;

/// Stitches that are looked through for that of a needle.
constexpr std::ptrdiff_t kReach = 5000;

LoopIndex stitchOf(const machine::Timeline& timeline, machine::OperationIndex operation) {
    const machine::LoopTable& loops = timeline.loops();
    const LoopIndex own = firstLoopOf(loops, operation);
    const machine::Operation& op = timeline.program().operations[static_cast<std::size_t>(operation)];
    const bool moves = op.kind == machine::OperationKind::Xfer || op.kind == machine::OperationKind::Drop ||
                       op.kind == machine::OperationKind::Amiss;
    if (own >= 0 || !moves) {
        return own;
    }
    const auto end = std::ranges::lower_bound(loops.loops, operation, {}, &machine::Loop::operation);
    const auto begin = end - std::min(kReach, end - loops.loops.begin());
    for (auto loop = end; loop != begin; --loop) {
        if (std::prev(loop)->needle == op.needle) {
            return static_cast<LoopIndex>(loop - loops.loops.begin() - 1);
        }
    }
    return -1;
}

} // namespace

ProblemMarks problemMarks(const machine::Timeline& timeline, const Diagnostics& problems) {
    ProblemMarks marks;
    for (const Diagnostic& problem : problems) {
        const auto operation = problem.place.operation;
        if (problem.severity == Severity::Info || operation < 0 || operation >= timeline.operationCount()) {
            continue;
        }
        const LoopIndex loop = stitchOf(timeline, operation);
        if (loop < 0) {
            continue;
        }
        const auto [at, first] = marks.try_emplace(loop, problem);
        if (!first && problem.severity > at->second.severity) {
            at->second = problem;
        }
    }
    return marks;
}

} // namespace knittsim::document
