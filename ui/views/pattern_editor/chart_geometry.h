#pragma once

#include <QPoint>
#include <QRect>
#include <QSize>

#include <cstdint>

namespace knittsim::ui {

/// Where the cells of a chart lie on screen, in device independent pixels. Course 0 is at the bottom, columns
/// count from the left; row numbers stand on the left and needle numbers below, both outside the scrolled
/// part.
struct ChartGeometry {
    static constexpr int kMinCell = 2;
    static constexpr int kMaxCell = 64;

    int columns = 0;
    int courses = 0;
    int cellWidth = 18;
    bool tall = false; ///< cells hold two stitches above each other
    QSize view;        ///< whole widget
    QSize header;      ///< width of the row numbers, height of the needle numbers
    QPoint scroll;     ///< content pixels hidden on the left and above

    /// Stitches are wider than high; even, so that a cell can be halved.
    int cellHeight() const { return cellHeightOf(cellWidth); }
    int cellHeightOf(int width) const { return width < 3 ? 2 : (width * (tall ? 60 : 41) / 50 + 1) / 2 * 2; }

    QSize content() const { return {columns * cellWidth, courses * cellHeight()}; }

    /// Part of the widget that shows cells.
    QRect chartArea() const;

    /// Where content pixel (0, 0) lies in the widget. A content smaller than the area stands in its middle.
    QPoint origin() const;

    QRect cellRect(std::int32_t course, std::int32_t column) const;

    struct Cell {
        std::int32_t course = -1; ///< -1 outside the chart
        std::int32_t column = -1;
        bool upperHalf = false;
    };
    Cell cellAt(QPoint position) const;

    struct Range {
        std::int32_t first = 0;
        std::int32_t end = 0;
    };
    Range visibleColumns() const;
    Range visibleCourses() const;

    /// The largest cell width up to `limit` at which all columns and courses fit, at least `least`.
    int fittingCell(int least, int limit) const;
};

/// The next zoom level up or down.
int nextCellWidth(int width, int direction);

} // namespace knittsim::ui
