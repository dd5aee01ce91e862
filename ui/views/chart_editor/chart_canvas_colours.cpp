// How the colours of the chart are knitted, and on which beds.

#include "ui/views/chart_editor/chart_canvas.h"
#include "ui/views/chart_editor/colour_method_menu.h"

#include <algorithm>

namespace knittsim::ui {

using pattern::CellRange;
using pattern::Chart;
using pattern::ColourMethod;

void ChartCanvas::chooseColourMethod() {
    const Chart& chart = shown();
    if (!m_project) {
        return;
    }
    const bool all = m_selection.empty();
    const CellRange courses = all ? CellRange{0, 0, chart.width, chart.height()} : m_selection;
    const auto first = chart.courses.begin() + courses.course;
    const ColourMethod method = first->colours;
    const bool same = std::all_of(first, first + courses.height,
                                  [&](const pattern::Course& course) { return course.colours == method; });
    auto* menu = new ColourMethodMenu(
        all ? tr("Colours of all courses") : tr("Colours of the selected courses"),
        same ? std::optional(method) : std::nullopt,
        [this, courses](ColourMethod chosen) { setColourMethod(courses, chosen); }, this);
    menu->popup(viewport()->mapToGlobal(QPoint(8, 8)));
}

void ChartCanvas::setColourMethod(CellRange courses, ColourMethod method) {
    if (pattern::isBacked(method) && shown().beds == pattern::BedUse::Single) {
        Chart chart = shown();
        if (!pattern::useBeds(chart, pattern::BedUse::Double)) {
            emit hovered(
                tr("A chart with cables or lace is knitted on one bed: its colours cannot have a back."));
            return;
        }
    }
    m_document.editChart(tr("knitting of the colours"), [&](Chart& chart) {
        if (pattern::isBacked(method)) {
            pattern::useBeds(chart, pattern::BedUse::Double);
        }
        const int end = std::min(courses.course + courses.height, chart.height());
        for (int c = courses.course; c < end; ++c) {
            chart.course(c).colours = method;
        }
    });
}

void ChartCanvas::useBothBeds(bool both) {
    bool done = true;
    m_document.editChart(both ? tr("both beds") : tr("one bed"), [&](Chart& chart) {
        done = pattern::useBeds(chart, both ? pattern::BedUse::Double : pattern::BedUse::Single);
    });
    if (!done) {
        emit hovered(tr("Moved loops, as of cables and lace, need a chart on one bed."));
    }
}

} // namespace knittsim::ui
