#pragma once

#include "core/fabric/fabric.h"
#include "core/machine/program.h"

namespace knittsim::document {

/// What is selected, the same for all views. Every field is -1 where it does not apply.
struct Selection {
    machine::LoopIndex loop = -1;
    machine::OperationIndex operation = -1;
    int line = -1; ///< 1-based line of the source

    bool empty() const { return loop < 0 && operation < 0 && line < 0; }
    bool operator==(const Selection&) const = default;
};

Selection selectionOfLoop(const machine::Program& program, const machine::LoopTable& loops,
                          machine::LoopIndex loop);

/// With several loops (plating) the first one is named.
Selection selectionOfOperation(const machine::Program& program, const machine::LoopTable& loops,
                               machine::OperationIndex operation);

/// The first operation written on the line; only the line where there is none.
Selection selectionOfLine(const machine::Program& program, const machine::LoopTable& loops, int line);

/// The first loop made by the operation, or -1.
machine::LoopIndex firstLoopOf(const machine::LoopTable& loops, machine::OperationIndex operation);

} // namespace knittsim::document
