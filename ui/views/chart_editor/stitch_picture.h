#pragma once

#include "core/pattern/chart.h"
#include "ui/views/pattern_editor/stitch_symbols.h"

#include <QIcon>

class QPainter;
class QRect;

namespace knittsim::ui {

/// Symbol of a stitch in `rect`, in `ink`.
void paintStitch(QPainter& painter, const QRectF& rect, pattern::Stitch stitch, SymbolSet symbols,
                 const QColor& ink);

/// The loop comes to rest on one that stays, as a decrease does; else the loops there go away, as in a cable.
bool isStacked(const std::vector<pattern::LoopMove>& moves, const pattern::LoopMove& move);
/// No other loop comes to where it was.
bool leavesHole(const std::vector<pattern::LoopMove>& moves, const pattern::LoopMove& move);

/// The loops that a course moves, from their cells to where they go; those in front over those behind.
/// `cellOf(wale)` gives the cell of the course in which they arrive.
void paintMoves(QPainter& painter, const std::vector<pattern::LoopMove>& moves,
                const std::function<QRectF(int)>& cellOf, SymbolSet symbols, const QColor& ink,
                const QColor& ground);

/// A small chart as a picture, in the colours of the palette at hand.
QPixmap pictureOf(const pattern::Chart& part, const QSize& size, double ratio, const QPalette& palette,
                  SymbolSet symbols);

QString stitchName(pattern::Stitch stitch);

} // namespace knittsim::ui
