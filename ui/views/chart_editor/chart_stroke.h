#pragma once

#include "core/pattern/catalogue.h"
#include "core/pattern/chart_edit.h"

#include <QString>

#include <memory>

namespace knittsim::ui {

enum class ChartTool { Select, Pencil, Line, Rectangle, Fill, Stamp };

/// One stroke of a tool, from press to release: what the chart looks like meanwhile. No widgets.
class ChartStroke {
public:
    /// `module`: what Stamp lays down; not null for that tool.
    ChartStroke(const pattern::Chart& before, ChartTool tool, pattern::Brush brush,
                const pattern::Module* module, pattern::CellPlace at);

    void moveTo(pattern::CellPlace at);

    const pattern::Chart& chart() const { return m_chart; }
    /// As the undo history names it.
    QString text() const;

private:
    void stampAt(pattern::CellPlace at);

    const pattern::Chart& m_before;
    pattern::Chart m_chart;
    ChartTool m_tool;
    pattern::Brush m_brush;
    const pattern::Module* m_module;
    pattern::CellPlace m_first;
    pattern::CellPlace m_last;
};

} // namespace knittsim::ui
