// What a designer does to the selection of the canvas, each one step on the undo stack.

#include "ui/views/chart_editor/chart_canvas.h"
#include "ui/views/chart_editor/chart_clipboard.h"

namespace knittsim::ui {

using pattern::CellPlace;
using pattern::CellRange;
using pattern::Chart;

void ChartCanvas::copy() const {
    if (m_project) {
        copyToClipboard(pattern::copyOf(m_project->chart, target()));
    }
}

void ChartCanvas::cut() {
    copy();
    m_document.editChart(tr("cut"), [range = target()](Chart& chart) { pattern::clear(chart, range); });
}

void ChartCanvas::paste() {
    const auto part = partOnClipboard();
    if (!part || !m_project) {
        return;
    }
    const CellPlace at = m_selection.empty() ? m_cursor : CellPlace{m_selection.wale, m_selection.course};
    m_document.editChart(tr("paste"), [&](Chart& chart) { pattern::paste(chart, at, *part); });
    select({at.wale, at.course, part->width, part->height()});
}

void ChartCanvas::clearSelected() {
    m_document.editChart(tr("clear"), [range = target()](Chart& chart) { pattern::clear(chart, range); });
}

void ChartCanvas::mirror(pattern::Mirror how) {
    const CellRange all{0, 0, shown().width, shown().height()};
    const CellRange range = m_selection.empty() ? all : m_selection;
    m_document.editChart(tr("mirror"), [&](Chart& chart) { pattern::mirror(chart, range, how); });
}

void ChartCanvas::rotate() {
    m_document.editChart(tr("rotate"), [this](Chart& chart) { pattern::rotate(chart, m_selection); });
}

void ChartCanvas::repeat() {
    if (m_selection.empty()) {
        return;
    }
    m_document.editChart(tr("repeat"), [this](Chart& chart) {
        const Chart part = pattern::copyOf(chart, m_selection);
        // The selection stays where it is; the repeats reach from it to all sides.
        const auto start = [](int at, int size) { return at - (at + size - 1) / size * size; };
        const int left = start(m_selection.wale, part.width);
        const int bottom = start(m_selection.course, part.height());
        for (int c = bottom; c < chart.height(); c += part.height()) {
            for (int w = left; w < chart.width; w += part.width) {
                pattern::paste(chart, {w, c}, part);
            }
        }
    });
}

void ChartCanvas::insertCourses() {
    m_document.editChart(tr("insert courses"), [range = target()](Chart& chart) {
        pattern::insertCourses(chart, range.course, range.height);
    });
}

void ChartCanvas::removeCourses() {
    m_document.editChart(tr("remove courses"), [range = target()](Chart& chart) {
        pattern::removeCourses(chart, range.course, range.height);
    });
}

void ChartCanvas::insertWales() {
    m_document.editChart(tr("insert wales"), [range = target()](Chart& chart) {
        pattern::insertWales(chart, range.wale, range.width);
    });
}

void ChartCanvas::removeWales() {
    m_document.editChart(tr("remove wales"), [range = target()](Chart& chart) {
        pattern::removeWales(chart, range.wale, range.width);
    });
}

} // namespace knittsim::ui
