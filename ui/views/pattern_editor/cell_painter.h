#pragma once

#include "ui/document/stitch_grid.h"

#include <QColor>
#include <QHash>
#include <QPainter>
#include <QPixmap>

namespace knittsim::ui {

/// Draws stitch symbols. Front stitches are a V, rear stitches a bump, tucks an arch, loops on empty needles
/// a ring; arrows on top tell transfers, a roof below stacked loops. Drawn symbols are kept, so that a chart
/// costs one copy a cell.
class CellPainter {
public:
    /// The symbol of one loop in a cell or half a cell; `ground` is the colour it stands on.
    void drawSymbol(QPainter& painter, const QRect& rect, document::StitchMark mark, const QColor& ground,
                    bool faint);

    /// The colour of a cell: rear stitches stand on a darker ground, what is not knitted yet fades into
    /// `base`.
    static QColor ground(const QColor& yarn, bool rear, bool faint, const QColor& base);

private:
    QHash<quint64, QPixmap> m_symbols;
};

/// A corner in the colour of a problem, on a rim that stands out from any yarn.
void paintProblemCorner(QPainter& painter, const QRectF& cell, const QColor& colour, const QColor& rim);

/// One symbol without a cache, for legends and thumbnails.
void paintSymbol(QPainter& painter, const QRectF& rect, document::StitchMark mark, const QColor& ink);

} // namespace knittsim::ui
