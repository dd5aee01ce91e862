#include "ui/views/pattern_editor/stitch_symbols.h"

#include <QPainter>
#include <QPainterPath>

#include <algorithm>

namespace knittsim::ui {

namespace {

using document::StitchKind;
using document::StitchMark;

/// What a stitch looks like. All shapes are paths in a unit box, y down.
QPainterPath faceOf(const StitchMark& mark) {
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

QPainterPath craftSymbolOf(const StitchMark& mark) {
    QPainterPath path;
    switch (mark.kind) {
    case StitchKind::CastOn:
        path.moveTo(0.22, 0.62);
        path.cubicTo(0.22, 0.92, 0.78, 0.92, 0.78, 0.62);
        break;
    case StitchKind::Tuck:
        path.moveTo(0.26, 0.84);
        path.cubicTo(0.26, 0.06, 0.74, 0.06, 0.74, 0.84);
        break;
    case StitchKind::Split:
        path.moveTo(0.5, 0.22);
        path.lineTo(0.5, 0.82);
        path.moveTo(0.22, 0.52);
        path.lineTo(0.78, 0.52);
        break;
    case StitchKind::Knit:
        if (mark.rear) {
            path.moveTo(0.24, 0.52);
            path.lineTo(0.76, 0.52);
        }
        break;
    }
    return path;
}

/// The yarn lies between the beds; it goes around a needle of the front bed downwards, of the rear bed
/// upwards.
QPainterPath notationOf(const StitchMark& mark) {
    QPainterPath path;
    const double way = mark.rear ? -1 : 1;
    const auto at = [way](double x, double y) { return QPointF(x, 0.5 + way * y); };
    path.moveTo(0, 0.5);
    switch (mark.kind) {
    case StitchKind::Knit: // the legs cross: a closed loop
        path.cubicTo(at(0.45, 0), at(0.84, 0.1), at(0.76, 0.32));
        path.cubicTo(at(0.70, 0.52), at(0.30, 0.52), at(0.24, 0.32));
        path.cubicTo(at(0.16, 0.1), at(0.55, 0), at(1, 0));
        break;
    case StitchKind::CastOn:
    case StitchKind::Tuck: // an open one
        path.cubicTo(at(0.16, 0), at(0.22, 0.04), at(0.24, 0.26));
        path.cubicTo(at(0.28, 0.52), at(0.72, 0.52), at(0.76, 0.26));
        path.cubicTo(at(0.78, 0.04), at(0.84, 0), at(1, 0));
        break;
    case StitchKind::Split:
        path.cubicTo(at(0.45, 0), at(0.84, 0.1), at(0.76, 0.32));
        path.cubicTo(at(0.70, 0.52), at(0.30, 0.52), at(0.24, 0.32));
        path.cubicTo(at(0.16, 0.1), at(0.55, 0), at(1, 0));
        path.moveTo(at(0.5, 0.2));
        path.lineTo(at(0.5, -0.4));
        break;
    }
    return path;
}

QPainterPath shapeOf(const StitchMark& mark, SymbolSet symbols) {
    return symbols == SymbolSet::Faces   ? faceOf(mark)
           : symbols == SymbolSet::Craft ? craftSymbolOf(mark)
                                         : notationOf(mark);
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

void paintNeedles(QPainter& painter, const QTransform& place, const QColor& ink, double unit) {
    const double radius = std::max(0.8, 0.06 * unit);
    const QPen pen = painter.pen();
    painter.setPen(Qt::NoPen);
    painter.setBrush(ink);
    for (const double y : {0.20, 0.80}) {
        painter.drawEllipse(place.map(QPointF(0.5, y)), radius, radius);
    }
    painter.setPen(pen);
    painter.setBrush(Qt::NoBrush);
}

} // namespace

void paintSymbol(QPainter& painter, const QRectF& rect, StitchMark mark, SymbolSet symbols,
                 const QColor& ink) {
    // Half cells are flat; the drawing keeps its shape and stands in their middle. The yarn of the notation
    // runs on from cell to cell.
    const bool technical = symbols == SymbolSet::Technical;
    const double width = technical ? rect.width() : std::min(rect.width(), rect.height() * 1.45);
    const QRectF box(rect.center().x() - width / 2, rect.top(), width, rect.height());
    QTransform place;
    place.translate(box.left(), box.top() + 0.06 * box.height());
    place.scale(box.width(), 0.88 * box.height());
    const double unit = std::min(box.width(), box.height() * 1.2);
    const double weight = symbols == SymbolSet::Faces && mark.kind == StitchKind::Knit ? 0.115 : 0.095;
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(ink, std::max(1.1, weight * unit), Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    if (technical) {
        painter.setPen(QPen(ink, std::max(1.0, 0.06 * unit), Qt::SolidLine, Qt::FlatCap, Qt::RoundJoin));
        paintNeedles(painter, place, ink, unit);
    }
    painter.drawPath(place.map(shapeOf(mark, symbols)));
    painter.setPen(QPen(ink, std::max(1.0, 0.065 * unit), Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPath(place.map(extrasOf(mark)));
}

void paintSymbol(QPainter& painter, const QRectF& rect, NoLoop what, SymbolSet symbols, const QColor& ink) {
    painter.setRenderHint(QPainter::Antialiasing);
    const QPointF middle = rect.center();
    const double unit = std::min(rect.width(), rect.height() * 1.2);
    if (symbols == SymbolSet::Technical && what != NoLoop::Empty) {
        QTransform place;
        place.translate(rect.left(), rect.top());
        place.scale(rect.width(), rect.height());
        painter.setPen(QPen(ink, std::max(1.0, 0.06 * unit)));
        paintNeedles(painter, place, ink, unit);
        if (what == NoLoop::Miss) {
            painter.drawLine(QPointF(rect.left(), middle.y()), QPointF(rect.right(), middle.y()));
        }
        return;
    }
    switch (what) {
    case NoLoop::Miss:
        if (symbols == SymbolSet::Craft) {
            const double half = 0.24 * unit;
            painter.setBrush(Qt::NoBrush);
            painter.setPen(
                QPen(ink, std::max(1.1, 0.095 * unit), Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
            painter.drawPolyline(
                QPolygonF{{middle + QPointF(-half, -1.2 * half), middle + QPointF(0, 1.2 * half),
                           middle + QPointF(half, -1.2 * half)}});
        } else {
            painter.setPen(QPen(ink, std::max(1.2, 0.12 * rect.height()), Qt::SolidLine, Qt::FlatCap));
            painter.drawLine(QPointF(rect.left(), middle.y()), QPointF(rect.right(), middle.y()));
        }
        break;
    case NoLoop::Rest: {
        const double radius = std::max(1.0, 0.1 * rect.width());
        painter.setPen(Qt::NoPen);
        painter.setBrush(ink);
        painter.drawEllipse(middle, radius, radius);
        break;
    }
    case NoLoop::Empty:
        if (symbols == SymbolSet::Craft) {
            QColor grey = ink;
            grey.setAlphaF(0.3F);
            painter.fillRect(rect, grey);
        } else {
            painter.setPen(QPen(ink, 1));
            painter.drawLine(rect.bottomLeft() + QPointF(2, -2), rect.topRight() + QPointF(-2, 2));
        }
        break;
    }
}

} // namespace knittsim::ui
