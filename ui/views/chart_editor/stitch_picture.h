#pragma once

#include "core/pattern/chart.h"
#include "ui/document/stitch_grid.h"

#include <QIcon>

class QPainter;
class QRect;

namespace knittsim::ui {

/// Symbol of a stitch in `rect`, in `ink`.
void paintStitch(QPainter& painter, const QRectF& rect, pattern::Stitch stitch, const QColor& ink);

/// The loops that a course moves, from their cells to where they go; those in front over those behind.
/// `cellOf(wale)` gives the cell of the course in which they arrive.
void paintMoves(QPainter& painter, const std::vector<pattern::LoopMove>& moves,
                const std::function<QRectF(int)>& cellOf, const QColor& ink, const QColor& ground);

/// A small chart as a picture, in the colours of the palette at hand.
QPixmap pictureOf(const pattern::Chart& part, const QSize& size, double ratio, const QPalette& palette);

QString stitchName(pattern::Stitch stitch);

} // namespace knittsim::ui
