#pragma once

#include "core/fabric/fabric.h"
#include "core/machine/timeline.h"

#include <cstdint>
#include <span>
#include <vector>

/// The open document: what is shown, which part is selected, and the bridge to the simulation.
namespace knittsim::document {

using machine::LoopIndex;
using machine::OperationIndex;

enum class StitchKind : std::uint8_t { CastOn, Knit, Tuck, Split };

/// How one loop is drawn in a pattern grid.
struct StitchMark {
    StitchKind kind = StitchKind::Knit;
    bool rear = false;        ///< made on the rear bed
    bool otherBed = false;    ///< moved to the other bed before the next loop came through it
    bool dropped = false;     ///< fell off its needle with nothing through it
    std::int8_t moved = 0;    ///< columns to the right until the next loop came through it
    std::uint8_t parents = 0; ///< loops it was pulled through; 2 and more are stacked

    bool operator==(const StitchMark&) const = default;
};

/// One needle of one course. A bed without a loop has -1 and count 0; with several loops on one bed the first
/// is named.
struct GridCell {
    std::int32_t column = 0;
    LoopIndex front = -1;
    LoopIndex rear = -1;
    std::uint8_t frontCount = 0;
    std::uint8_t rearCount = 0;
};

/// Yarn that passes the columns [first, last] of a course without making a loop there.
struct GridFloat {
    std::int32_t first = 0;
    std::int32_t last = 0;
    machine::CarrierIndex carrier = 0;
    LoopIndex before = -1; ///< loop that the yarn comes from
};

struct GridPlace {
    std::int32_t course = -1;
    std::int32_t column = 0;
    bool rear = false;

    bool operator==(const GridPlace&) const = default;
};

/// The fabric as a chart: courses (0 = first knitted) by columns. A column is the front needle that a loop
/// faces, so rear loops made at a racking stand where the racking put them. Sparse; memory is linear in the
/// number of loops. Plain value, immutable once built.
class StitchGrid {
public:
    StitchGrid() = default;
    StitchGrid(const machine::LoopTable& made, const fabric::Fabric& fabric);

    std::int32_t courseCount() const { return static_cast<std::int32_t>(m_firstCell.size()) - 1; }
    std::int32_t firstColumn() const { return m_firstColumn; }
    std::int32_t columnCount() const { return m_columnCount; }
    /// Some cell has loops on both beds.
    bool usesBothBeds() const { return m_usesBothBeds; }
    std::size_t loopCount() const { return m_marks.size(); }

    /// Cells of a course, by rising column.
    std::span<const GridCell> row(std::int32_t course) const;

    /// Floats of a course in the order knitted.
    std::span<const GridFloat> floats(std::int32_t course) const;

    /// The cell, or nullptr where no loop was made.
    const GridCell* cellAt(std::int32_t course, std::int32_t column) const;

    /// The first float over this column, or nullptr.
    const GridFloat* floatAt(std::int32_t course, std::int32_t column) const;

    GridPlace placeOf(LoopIndex loop) const { return m_places[static_cast<std::size_t>(loop)]; }
    StitchMark markOf(LoopIndex loop) const { return m_marks[static_cast<std::size_t>(loop)]; }

private:
    void fillCells();
    void fillFloats(const machine::LoopTable& made);

    std::int32_t m_firstColumn = 0;
    std::int32_t m_columnCount = 0;
    bool m_usesBothBeds = false;
    std::vector<StitchMark> m_marks;          ///< by loop
    std::vector<GridPlace> m_places;          ///< by loop
    std::vector<GridCell> m_cells;            ///< course after course
    std::vector<std::int32_t> m_firstCell{0}; ///< by course, and the end
    std::vector<GridFloat> m_floats;
    std::vector<std::int32_t> m_firstFloat{0};
};

/// Column that a needle faces at a racking: rear needle B stands at B + rack, half pitches count to the left.
std::int32_t columnOf(machine::Needle needle, double rack);

} // namespace knittsim::document
