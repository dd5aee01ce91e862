#pragma once

#include "ui/views/pattern_editor/stitch_symbols.h"

#include <QPalette>
#include <QString>

#include <functional>
#include <vector>

namespace knittsim::ui {

/// A drawing of a chart and what it stands for.
struct LegendEntry {
    QString name;
    std::function<void(QPainter& painter, const QRectF& rect, const QColor& ink)> paint;
};

/// The symbols that this grid shows, each once.
std::vector<LegendEntry> legendOf(const document::StitchGrid& grid, SymbolSet symbols);

/// An entry for a yarn.
LegendEntry yarnEntry(const QString& name, const QColor& colour);

} // namespace knittsim::ui
