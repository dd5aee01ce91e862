// What a designer does to the selection of the canvas, each one step on the undo stack.

#include "ui/views/chart_editor/chart_canvas.h"
#include "ui/views/chart_editor/chart_clipboard.h"

#include <algorithm>
#include <cstdlib>

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
    m_document.editChart(tr("repeat"), [this](Chart& chart) {
        pattern::repeatOver(chart, {0, 0, chart.width, chart.height()}, m_selection);
    });
}

void ChartCanvas::repeatBy(int wales, int courses) {
    if (m_selection.empty()) {
        return;
    }
    const CellRange before = m_selection;
    const CellRange range =
        pattern::inside(shown(), {before.wale + std::min(wales, 0), before.course + std::min(courses, 0),
                                  before.width + std::abs(wales), before.height + std::abs(courses)});
    const CellRange from = before == m_repeated ? m_repeatedFrom : before; // the same key again
    m_document.editChart(tr("repeat"), [&](Chart& chart) { pattern::repeatOver(chart, range, from); });
    select(range);
    m_repeated = range;
    m_repeatedFrom = from;
}

void ChartCanvas::shift(int wales, int courses) {
    const CellRange all{0, 0, shown().width, shown().height()};
    const CellRange range = m_selection.empty() ? all : m_selection;
    m_document.editChart(tr("shift"), [&](Chart& chart) { pattern::shift(chart, range, wales, courses); });
}

void ChartCanvas::moveSelected(int wales, int courses) {
    const CellRange from = m_selection;
    const CellRange to{from.wale + wales, from.course + courses, from.width, from.height};
    if (from.empty() || to != pattern::inside(shown(), to)) {
        return;
    }
    m_document.editChart(tr("move"), [&](Chart& chart) {
        const Chart part = pattern::copyOf(chart, from);
        pattern::clear(chart, from);
        pattern::paste(chart, {to.wale, to.course}, part);
    });
    select(to);
}

void ChartCanvas::pick() {
    if (m_project) {
        emit picked(shown().at(m_cursor.wale, m_cursor.course));
    }
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
