#include "ui/views/pattern_editor/cell_painter.h"

#include "ui/views/style/appearance.h"

#include <algorithm>

namespace knittsim::ui {

namespace {

using document::StitchMark;

/// Most cells of a chart share few symbols; a cache that grows beyond this is of an older zoom.
constexpr int kMaxKept = 512;

QColor mixed(const QColor& a, const QColor& b, float share) {
    return QColor::fromRgbF(a.redF() + (b.redF() - a.redF()) * share,
                            a.greenF() + (b.greenF() - a.greenF()) * share,
                            a.blueF() + (b.blueF() - a.blueF()) * share);
}

quint64 keyOf(const QSize& size, const StitchMark& mark, SymbolSet symbols, bool darkInk, bool faint) {
    const int extras = mark.moved == 0 ? 0 : mark.moved > 0 ? 1 : 2;
    quint64 key = static_cast<quint64>(size.width()) << 40U | static_cast<quint64>(size.height()) << 24U;
    key |= static_cast<quint64>(mark.kind) << 16U | static_cast<quint64>(extras) << 12U;
    key |= static_cast<quint64>(mark.rear) << 8U | static_cast<quint64>(mark.otherBed) << 7U;
    key |= static_cast<quint64>(mark.dropped) << 6U | static_cast<quint64>(mark.parents > 1) << 5U;
    return key | static_cast<quint64>(darkInk) << 4U | static_cast<quint64>(faint) << 3U |
           static_cast<quint64>(symbols);
}

} // namespace

void paintProblemCorner(QPainter& painter, const QRectF& cell, const QColor& colour, const QColor& rim) {
    const double size = std::max(7.0, 0.6 * std::min(cell.width(), cell.height()));
    const QPointF corner = cell.topRight();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(rim, 1));
    painter.setBrush(colour);
    painter.drawPolygon(QPolygonF{{corner, corner - QPointF(size, 0), corner + QPointF(0, size)}});
}

QColor CellPainter::ground(const QColor& yarn, bool rear, bool faint, const QColor& base) {
    const QColor full = rear ? mixed(yarn, Qt::black, yarn.lightnessF() < 0.25F ? 0.45F : 0.24F) : yarn;
    return faint ? mixed(full, base, 0.82F) : full;
}

void CellPainter::drawSymbol(QPainter& painter, const QRect& rect, StitchMark mark, SymbolSet symbols,
                             const QColor& ground, bool faint) {
    QColor ink = inkOn(ground);
    const bool darkInk = ink.lightness() < 128;
    const quint64 key = keyOf(rect.size(), mark, symbols, darkInk, faint);
    auto found = m_symbols.constFind(key);
    if (found == m_symbols.constEnd()) {
        if (m_symbols.size() > kMaxKept) {
            m_symbols.clear();
        }
        const double ratio = painter.device()->devicePixelRatioF();
        QPixmap pixmap(rect.size() * ratio);
        pixmap.setDevicePixelRatio(ratio);
        pixmap.fill(Qt::transparent);
        QPainter symbol(&pixmap);
        ink.setAlphaF(faint ? 0.25F : darkInk ? 0.72F : 0.86F);
        paintSymbol(symbol, QRectF(QPointF(0, 0), QSizeF(rect.size())), mark, symbols, ink);
        symbol.end();
        found = m_symbols.insert(key, pixmap);
    }
    painter.drawPixmap(rect.topLeft(), *found);
}

} // namespace knittsim::ui
