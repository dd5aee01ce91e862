#pragma once

#include "ui/views/pattern_editor/stitch_symbols.h"

#include <QColor>
#include <QHash>
#include <QPainter>
#include <QPixmap>

namespace knittsim::ui {

/// Draws stitch symbols. Drawn symbols are kept, so that a chart costs one copy a cell.
class CellPainter {
public:
    /// The symbol of one loop in a cell or half a cell; `ground` is the colour it stands on.
    void drawSymbol(QPainter& painter, const QRect& rect, document::StitchMark mark, SymbolSet symbols,
                    const QColor& ground, bool faint);

    /// The colour of a cell: rear stitches stand on a darker ground, what is not knitted yet fades into
    /// `base`.
    static QColor ground(const QColor& yarn, bool rear, bool faint, const QColor& base);

private:
    QHash<quint64, QPixmap> m_symbols;
};

/// A corner in the colour of a problem, on a rim that stands out from any yarn.
void paintProblemCorner(QPainter& painter, const QRectF& cell, const QColor& colour, const QColor& rim);

} // namespace knittsim::ui
