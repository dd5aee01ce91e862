#pragma once

#include "tests/gui/window/window_fixture.h"
#include "ui/views/chart_editor/chart_canvas.h"

namespace knittsim::ui {

/// A window with a chart to draw in.
class ChartFixture : public WindowFixture {
protected:
    ChartCanvas* canvas() { return child<ChartCanvas>("chartCanvas"); }
    const pattern::Chart& chart() { return document().project()->chart; }

    void newChart(int wales, int courses); ///< of knit stitches, with the pencil

    /// Middle of a cell in the viewport.
    QPoint place(pattern::CellPlace cell);
    /// From the middle of one cell to that of another.
    void stroke(pattern::CellPlace from, pattern::CellPlace to);
};

} // namespace knittsim::ui
