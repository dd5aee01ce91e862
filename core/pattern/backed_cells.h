#pragma once

#include "core/machine/operation.h"
#include "core/pattern/chart.h"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

/// What a program makes of wales that have a needle on each bed, and what of it is a back.
namespace knittsim::pattern {

struct NeedleWork {
    machine::OperationKind kind = machine::OperationKind::Knit; ///< Knit, Tuck or Miss
    int yarn = 0;
};
using WaleWork = std::array<std::optional<NeedleWork>, 2>; ///< by bed

/// Nothing: neither needle works. `backed`: behind a miss the rear needle may knit the back.
std::optional<Cell> cellOnTwoBeds(const WaleWork& work, bool backed);

/// Writes into a course with isBacked() what its cells are when the rear bed knits a back behind them.
/// `cells` say what both beds do; `rear` has by wale a bit for each yarn that the rear bed knits. Where the
/// back would not do that, the cell itself works both beds.
void takeBacked(Chart& chart, int course, const std::vector<Cell>& cells,
                const std::vector<std::uint64_t>& rear);

/// Whether passes, each of one yarn with its needles numbered as wales, are all that a course with a back
/// does, and some of it is the back. `chart` is overwritten; it gives the size and the number of yarns.
bool areBackedCourse(Chart& chart, int course, double rack,
                     std::span<const std::span<const machine::Operation>> passes);

} // namespace knittsim::pattern
