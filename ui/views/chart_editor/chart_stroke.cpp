#include "ui/views/chart_editor/chart_stroke.h"

#include <QCoreApplication>

namespace knittsim::ui {

using pattern::CellPlace;

ChartStroke::ChartStroke(const pattern::Chart& before, ChartTool tool, pattern::Brush brush,
                         const pattern::Module* module, CellPlace at)
    : m_before(before), m_chart(before), m_tool(tool), m_brush(brush), m_module(module), m_first(at),
      m_last(at) {
    if (tool == ChartTool::Fill) {
        pattern::fill(m_chart, at, brush);
    } else {
        moveTo(at);
    }
}

void ChartStroke::moveTo(CellPlace at) {
    switch (m_tool) {
    case ChartTool::Pencil:
        pattern::paint(m_chart, pattern::lineOf(m_last, at), m_brush);
        break;
    case ChartTool::Line:
        m_chart = m_before;
        pattern::paint(m_chart, pattern::lineOf(m_first, at), m_brush);
        break;
    case ChartTool::Rectangle:
        m_chart = m_before;
        pattern::paintRange(m_chart, pattern::rangeOf(m_first, at), m_brush);
        break;
    case ChartTool::Stamp:
        stampAt(at);
        break;
    case ChartTool::Select:
    case ChartTool::Fill:
        break;
    }
    m_last = at;
}

/// A press stamps the module once; dragging lays it side by side over the range.
void ChartStroke::stampAt(CellPlace at) {
    m_chart = m_before;
    const pattern::Chart& part = m_module->part;
    if (!m_module->tiles) {
        pattern::paste(m_chart, at, part, pattern::PasteWhat::Stitches);
        return;
    }
    const pattern::CellRange dragged = pattern::rangeOf(m_first, at);
    const auto whole = [](int size, int of) { return (size + of - 1) / of * of; };
    const pattern::CellRange range{dragged.wale, dragged.course, whole(dragged.width, part.width),
                                   whole(dragged.height, part.height())};
    pattern::tile(m_chart, range, part, pattern::PasteWhat::Stitches);
}

QString ChartStroke::text() const {
    const auto tr = [](const char* text) {
        return QCoreApplication::translate("knittsim::ui::ChartStroke", text);
    };
    switch (m_tool) {
    case ChartTool::Pencil:
        return tr("pencil");
    case ChartTool::Line:
        return tr("line");
    case ChartTool::Rectangle:
        return tr("rectangle");
    case ChartTool::Fill:
        return tr("fill");
    case ChartTool::Stamp:
        return QString::fromStdString(m_module->name);
    case ChartTool::Select:
        break;
    }
    return {};
}

} // namespace knittsim::ui
