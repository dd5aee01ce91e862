#pragma once

#include "core/base/json_reader.h"
#include "core/pattern/chart.h"

#include <span>
#include <string>
#include <vector>

/// Cells and moves as a project file says them (project.h).
namespace knittsim::pattern {

/// A letter for each cell.
std::string stitchLetters(std::span<const Cell> cells);
/// A digit for each cell, or a single one where all are the same.
std::string yarnDigits(std::span<const Cell> cells);
char yarnDigit(std::size_t yarn);

/// From the keys `stitches` and `yarns`. Errors go to the reader; false then.
bool readCells(JsonReader& reader, std::span<Cell> cells);

/// "[[1, 2], [3, 4]]"
std::string movesText(const std::vector<LoopMove>& moves);
/// From the key `moves`, which may be missing. What is far outside of every chart is just outside.
std::vector<LoopMove> readMoves(JsonReader& reader);

} // namespace knittsim::pattern
