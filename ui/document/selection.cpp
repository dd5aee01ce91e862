#include "ui/document/selection.h"

#include <algorithm>

namespace knittsim::document {

using machine::LoopIndex;
using machine::OperationIndex;

LoopIndex firstLoopOf(const machine::LoopTable& loops, OperationIndex operation) {
    const auto found =
        std::lower_bound(loops.loops.begin(), loops.loops.end(), operation,
                         [](const machine::Loop& loop, OperationIndex key) { return loop.operation < key; });
    const bool made = found != loops.loops.end() && found->operation == operation;
    return made ? static_cast<LoopIndex>(found - loops.loops.begin()) : -1;
}

Selection selectionOfOperation(const machine::Program& program, const machine::LoopTable& loops,
                               OperationIndex operation) {
    if (operation < 0 || operation >= static_cast<OperationIndex>(program.operations.size())) {
        return {};
    }
    const machine::Operation& op = program.operations[static_cast<std::size_t>(operation)];
    return {firstLoopOf(loops, operation), operation, op.line};
}

Selection selectionOfLoop(const machine::Program& program, const machine::LoopTable& loops, LoopIndex loop) {
    if (loop < 0 || loop >= static_cast<LoopIndex>(loops.loops.size())) {
        return {};
    }
    Selection selection =
        selectionOfOperation(program, loops, loops.loops[static_cast<std::size_t>(loop)].operation);
    selection.loop = loop;
    return selection;
}

Selection selectionOfLine(const machine::Program& program, const machine::LoopTable& loops, int line) {
    const auto found = std::find_if(program.operations.begin(), program.operations.end(),
                                    [line](const machine::Operation& op) { return op.line == line; });
    if (found == program.operations.end()) {
        return {-1, -1, line};
    }
    return selectionOfOperation(program, loops,
                                static_cast<OperationIndex>(found - program.operations.begin()));
}

} // namespace knittsim::document
