#pragma once

#include "core/machine/operation.h"
#include "core/pattern/chart.h"

namespace knittsim::pattern {

/// A course of a program from outside that a chart cannot say: its operations word for word, what they make,
/// and what they begin with. A cell that is changed later is knitted as the chart says, in place of what the
/// program does on that wale; so is a move that is added. Where a move of the program is taken away, the
/// whole course is knitted as the chart says.
struct ProgramCourse {
    std::vector<machine::Operation> operations; ///< needles as wales, carriers as yarns of the chart
    std::vector<std::string> texts;             ///< of operations
    std::vector<Cell> cells;                    ///< by wale: what they make
    std::vector<LoopMove> moves;                ///< of the loops that were there before
    std::vector<std::uint8_t> loops; ///< by wale, before: bit 1 << Bed for each bed that holds some
    std::vector<std::uint8_t> in;    ///< yarns in action before, rising
    double rack = 0;                 ///< before, pitches

    bool operator==(const ProgramCourse&) const = default;
};

/// Operations of this kind mean Operation::needle, or Operation::target too.
bool namesNeedle(machine::OperationKind kind);
bool namesTarget(machine::OperationKind kind);

/// The course is knitted by its program, but for the cells that were changed.
bool keepsProgram(const Course& course);
bool isAsInProgram(const Chart& chart, int wale, int course);
/// Moves that are not those of the program; all of them where there is none.
std::vector<LoopMove> addedMoves(const Course& course);
/// Yarns that the operations name, rising.
std::vector<int> yarnsOf(const ProgramCourse& course);

/// New wales left of `wale` in which nothing happens.
std::shared_ptr<const ProgramCourse> withWales(const ProgramCourse& course, int wale, int count);
/// Without what happens on wales [wale, wale + count).
std::shared_ptr<const ProgramCourse> withoutWales(const ProgramCourse& course, int wale, int count);

} // namespace knittsim::pattern
