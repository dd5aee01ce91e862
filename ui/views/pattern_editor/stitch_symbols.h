#pragma once

#include "ui/document/stitch_grid.h"
#include "ui/views/pattern_editor/chart_look.h"

class QColor;
class QPainter;
class QRectF;

namespace knittsim::ui {

/// The symbol of one loop. In every set arrows on top tell transfers, a roof below stacked loops, a cross
/// loops that were dropped.
void paintSymbol(QPainter& painter, const QRectF& rect, document::StitchMark mark, SymbolSet symbols,
                 const QColor& ink);

/// What a needle does that makes no loop.
enum class NoLoop : std::uint8_t { Miss, Rest, Empty };
void paintSymbol(QPainter& painter, const QRectF& rect, NoLoop what, SymbolSet symbols, const QColor& ink);

} // namespace knittsim::ui
