#pragma once

#include "core/pattern/chart.h"

#include <optional>
#include <span>
#include <vector>

/// Changes of a chart: pure functions of its value. Places outside of the chart are left out, so a tool may
/// run over the edge.
namespace knittsim::pattern {

/// A place of a chart.
struct CellPlace {
    int wale = 0;
    int course = 0;

    auto operator<=>(const CellPlace&) const = default;
};

/// Wales [wale, wale + width) of the courses [course, course + height).
struct CellRange {
    int wale = 0;
    int course = 0;
    int width = 0;
    int height = 0;

    bool empty() const { return width <= 0 || height <= 0; }
    bool contains(CellPlace p) const {
        return p.wale >= wale && p.wale < wale + width && p.course >= course && p.course < course + height;
    }
    bool operator==(const CellRange&) const = default;
};

/// The smallest range that holds both places.
CellRange rangeOf(CellPlace a, CellPlace b);
/// Of a range, what lies in the chart.
CellRange inside(const Chart& chart, CellRange range);

/// What a tool leaves behind in a cell: a stitch, a yarn, or both.
struct Brush {
    std::optional<Stitch> stitch;
    std::optional<std::uint8_t> yarn;

    void paint(Cell& cell) const {
        cell.stitch = stitch.value_or(cell.stitch);
        cell.yarn = yarn.value_or(cell.yarn);
    }
};

/// Cells from one place to another, both included, each beside or across the corner of the one before
/// (Bresenham's line).
std::vector<CellPlace> lineOf(CellPlace from, CellPlace to);

void paint(Chart& chart, std::span<const CellPlace> places, const Brush& brush);
void paintRange(Chart& chart, CellRange range, const Brush& brush, bool outlineOnly = false);
/// All cells like the one at `from` that it touches by an edge.
void fill(Chart& chart, CellPlace from, const Brush& brush);

/// A part as a chart of its own. Moved loops come along when both their ends lie in it.
Chart copyOf(const Chart& chart, CellRange range);

/// What of a part is laid down.
enum class PasteWhat : std::uint8_t {
    Everything, ///< stitches, moved loops and yarns
    Stitches,   ///< stitches and moved loops: the yarns stay
};

/// Lays a part down with its lower left cell at `at`. Moved loops that end or begin in the range go; those of
/// the part come in where both their ends lie in the chart. Yarns that the chart does not have become its
/// first; a chart for two beds takes no moves, one for a single bed no stitches on both.
void paste(Chart& chart, CellPlace at, const Chart& part, PasteWhat what = PasteWhat::Everything);

/// The part again and again over the range, from its lower left corner.
void tile(Chart& chart, CellRange range, const Chart& part, PasteWhat what = PasteWhat::Everything);

/// The cells of `source` again and again over the range, to all sides; they stay where they are.
void repeatOver(Chart& chart, CellRange range, CellRange source);

/// Knit stitches with the yarn that was there, no moved loops.
void clear(Chart& chart, CellRange range);

enum class Mirror : std::uint8_t { LeftRight, UpDown };
void mirror(Chart& chart, CellRange range, Mirror how);
/// By a quarter to the right; only a square range can turn, others are left as they are. Moved loops go.
bool rotate(Chart& chart, CellRange range);
/// What leaves the range on one side comes in on the other.
void shift(Chart& chart, CellRange range, int wales, int courses);

/// New courses below `course` look like it; new wales left of `wale` likewise.
void insertCourses(Chart& chart, int course, int count);
void insertWales(Chart& chart, int wale, int count);
/// At least one course and one wale stay.
void removeCourses(Chart& chart, int course, int count);
void removeWales(Chart& chart, int wale, int count);

/// New courses at the end that draw each loop over its neighbour, from the right to the left, until one is
/// left. Only a chart on one bed; false, and nothing is done, elsewhere and where there is nothing to bind
/// off.
bool bindOff(Chart& chart);

/// Lets the chart work on one bed or on both. False, and nothing is done, where loops are moved: that needs
/// one bed. On one bed cells keep what the front shows; backs of colours and rackings go.
bool useBeds(Chart& chart, BedUse beds);

/// Tucks and misses of a chart on two beds that name no bed go to the rear one, where only that holds a loop.
void nameRearBeds(Chart& chart);

/// The difference of two charts, for undo: only the courses between the first and the last that differ.
class ChartPatch {
public:
    ChartPatch(const Chart& before, const Chart& after);

    bool empty() const { return m_before == m_after; }
    void apply(Chart& chart) const { replace(chart, m_before, m_after); }
    void revert(Chart& chart) const { replace(chart, m_after, m_before); }

private:
    struct Part {
        int width = 0;
        BedUse beds = BedUse::Single;
        std::vector<ChartYarn> yarns;
        std::vector<Cell> cells;
        std::vector<Course> courses;
        bool operator==(const Part&) const = default;
    };
    Part partOf(const Chart& chart, int end) const;
    void replace(Chart& chart, const Part& from, const Part& to) const;

    int m_first = 0; ///< course
    Part m_before;
    Part m_after;
};

} // namespace knittsim::pattern
