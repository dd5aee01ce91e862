#include "ui/views/pattern_editor/cell_painter.h"

#include "ui/views/style/appearance.h"

#include <QPainterPath>

#include <algorithm>

namespace knittsim::ui {

namespace {

using document::StitchKind;
using document::StitchMark;

/// Most cells of a chart share few symbols; a cache that grows beyond this is of an older zoom.
constexpr int kMaxKept = 512;

QColor mixed(const QColor& a, const QColor& b, float share) {
    return QColor::fromRgbF(a.redF() + (b.redF() - a.redF()) * share,
                            a.greenF() + (b.greenF() - a.greenF()) * share,
                            a.blueF() + (b.blueF() - a.blueF()) * share);
}

/// A path in a unit box, y down.
QPainterPath shapeOf(const StitchMark& mark) {
    QPainterPath path;
    switch (mark.kind) {
    case StitchKind::CastOn:
        path.moveTo(0.28, 0.80);
        path.cubicTo(0.44, 0.66, 0.24, 0.50, 0.30, 0.36);
        path.cubicTo(0.36, 0.18, 0.64, 0.18, 0.70, 0.36);
        path.cubicTo(0.76, 0.50, 0.56, 0.66, 0.72, 0.80);
        break;
    case StitchKind::Tuck:
        path.moveTo(0.24, 0.82);
        path.cubicTo(0.24, 0.02, 0.76, 0.02, 0.76, 0.82);
        break;
    case StitchKind::Split:
        path.moveTo(0.22, 0.20);
        path.lineTo(0.5, 0.56);
        path.lineTo(0.78, 0.20);
        path.moveTo(0.5, 0.56);
        path.lineTo(0.5, 0.84);
        break;
    case StitchKind::Knit:
        if (mark.rear) {
            path.moveTo(0.18, 0.60);
            path.cubicTo(0.32, 0.36, 0.68, 0.36, 0.82, 0.60);
        } else {
            path.moveTo(0.22, 0.20);
            path.lineTo(0.5, 0.78);
            path.lineTo(0.78, 0.20);
        }
        break;
    }
    return path;
}

/// Arrow heads for transfers, a roof for stacked loops, a cross for dropped ones.
QPainterPath extrasOf(const StitchMark& mark) {
    QPainterPath path;
    if (mark.moved != 0) {
        const double way = mark.moved > 0 ? 1 : -1;
        path.moveTo(0.5 - 0.30 * way, 0.10);
        path.lineTo(0.5 + 0.30 * way, 0.10);
        path.moveTo(0.5 + 0.12 * way, 0.01);
        path.lineTo(0.5 + 0.32 * way, 0.10);
        path.lineTo(0.5 + 0.12 * way, 0.19);
    } else if (mark.otherBed) {
        const double tip = mark.rear ? 0.46 : 0.04;
        const double tail = mark.rear ? 0.04 : 0.46;
        const double barb = tip + (tail - tip) * 0.4;
        path.moveTo(0.90, tail);
        path.lineTo(0.90, tip);
        path.moveTo(0.82, barb);
        path.lineTo(0.90, tip);
        path.lineTo(0.98, barb);
    }
    if (mark.parents > 1) {
        path.moveTo(0.30, 0.98);
        path.lineTo(0.50, 0.86);
        path.lineTo(0.70, 0.98);
    }
    if (mark.dropped) {
        path.moveTo(0.06, 0.06);
        path.lineTo(0.24, 0.24);
        path.moveTo(0.24, 0.06);
        path.lineTo(0.06, 0.24);
    }
    return path;
}

quint64 keyOf(const QSize& size, const StitchMark& mark, bool darkInk, bool faint) {
    const int extras = mark.moved == 0 ? 0 : mark.moved > 0 ? 1 : 2;
    quint64 key = static_cast<quint64>(size.width()) << 40U | static_cast<quint64>(size.height()) << 24U;
    key |= static_cast<quint64>(mark.kind) << 16U | static_cast<quint64>(extras) << 12U;
    key |= static_cast<quint64>(mark.rear) << 8U | static_cast<quint64>(mark.otherBed) << 7U;
    key |= static_cast<quint64>(mark.dropped) << 6U | static_cast<quint64>(mark.parents > 1) << 5U;
    return key | static_cast<quint64>(darkInk) << 4U | static_cast<quint64>(faint) << 3U;
}

} // namespace

void paintSymbol(QPainter& painter, const QRectF& rect, StitchMark mark, const QColor& ink) {
    // Half cells are flat; the drawing keeps its shape and stands in their middle.
    const double width = std::min(rect.width(), rect.height() * 1.45);
    const QRectF box(rect.center().x() - width / 2, rect.top(), width, rect.height());
    QTransform place;
    place.translate(box.left(), box.top() + 0.06 * box.height());
    place.scale(box.width(), 0.88 * box.height());
    const double unit = std::min(box.width(), box.height() * 1.2);
    const double weight = mark.kind == StitchKind::Knit ? 0.115 : 0.095;
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(ink, std::max(1.1, weight * unit), Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPath(place.map(shapeOf(mark)));
    painter.setPen(QPen(ink, std::max(1.0, 0.065 * unit), Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPath(place.map(extrasOf(mark)));
}

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

void CellPainter::drawSymbol(QPainter& painter, const QRect& rect, StitchMark mark, const QColor& ground,
                             bool faint) {
    QColor ink = inkOn(ground);
    const bool darkInk = ink.lightness() < 128;
    const quint64 key = keyOf(rect.size(), mark, darkInk, faint);
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
        paintSymbol(symbol, QRectF(QPointF(0, 0), QSizeF(rect.size())), mark, ink);
        symbol.end();
        found = m_symbols.insert(key, pixmap);
    }
    painter.drawPixmap(rect.topLeft(), *found);
}

} // namespace knittsim::ui
