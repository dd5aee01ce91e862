#include "ui/views/chart_editor/stitch_picture.h"

#include "ui/views/pattern_editor/cell_painter.h"
#include "ui/views/style/appearance.h"

#include <QCoreApplication>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>

namespace knittsim::ui {

using document::StitchKind;
using document::StitchMark;
using pattern::Stitch;

void paintStitch(QPainter& painter, const QRectF& rect, Stitch stitch, const QColor& ink) {
    painter.setRenderHint(QPainter::Antialiasing);
    const QPointF middle = rect.center();
    switch (stitch) {
    case Stitch::Knit:
        paintSymbol(painter, rect, {.kind = StitchKind::Knit}, ink);
        break;
    case Stitch::Purl:
        paintSymbol(painter, rect, {.kind = StitchKind::Knit, .rear = true}, ink);
        break;
    case Stitch::Tuck:
        paintSymbol(painter, rect, {.kind = StitchKind::Tuck}, ink);
        break;
    case Stitch::Both: {
        const QRectF upper(rect.topLeft(), QSizeF(rect.width(), rect.height() / 2));
        paintSymbol(painter, upper, {.kind = StitchKind::Knit, .rear = true}, ink);
        paintSymbol(painter, upper.translated(0, rect.height() / 2), {.kind = StitchKind::Knit}, ink);
        break;
    }
    case Stitch::Miss:
        painter.setPen(QPen(ink, std::max(1.2, 0.12 * rect.height()), Qt::SolidLine, Qt::FlatCap));
        painter.drawLine(QPointF(rect.left(), middle.y()), QPointF(rect.right(), middle.y()));
        break;
    case Stitch::Rest:
        painter.setPen(Qt::NoPen);
        painter.setBrush(ink);
        painter.drawEllipse(middle, std::max(1.0, 0.1 * rect.width()), std::max(1.0, 0.1 * rect.width()));
        break;
    case Stitch::Empty:
        painter.setPen(QPen(ink, 1));
        painter.drawLine(rect.bottomLeft() + QPointF(2, -2), rect.topRight() + QPointF(-2, 2));
        break;
    }
}

void paintMoves(QPainter& painter, const std::vector<pattern::LoopMove>& moves,
                const std::function<QRectF(int)>& cellOf, const QColor& ink, const QColor& ground) {
    painter.setRenderHint(QPainter::Antialiasing);
    // The first of two that cross lies in front, so it is drawn last.
    for (auto move = moves.rbegin(); move != moves.rend(); ++move) {
        const QRectF from = cellOf(move->from);
        const QRectF to = cellOf(move->to);
        QPainterPath path(QPointF(from.center().x(), from.bottom()));
        const double mid = from.center().y();
        path.cubicTo({from.center().x(), mid}, {to.center().x(), mid}, {to.center().x(), to.top()});
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(ground, std::max(3.0, 0.42 * from.width()), Qt::SolidLine, Qt::FlatCap));
        painter.drawPath(path);
        painter.setPen(QPen(ink, std::max(1.5, 0.16 * from.width()), Qt::SolidLine, Qt::FlatCap));
        painter.drawPath(path);
        const bool leavesHole = std::ranges::none_of(
            moves, [&](const pattern::LoopMove& other) { return other.to == move->from; });
        if (leavesHole) {
            const double radius = 0.24 * std::min(from.width(), from.height());
            painter.setPen(QPen(ink, std::max(1.2, 0.1 * from.width())));
            painter.setBrush(ground);
            painter.drawEllipse(from.center(), radius, radius);
        }
    }
}

QPixmap pictureOf(const pattern::Chart& part, const QSize& size, double ratio, const QPalette& palette) {
    QPixmap pixmap(size * ratio);
    pixmap.setDevicePixelRatio(ratio);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    const QColor base = palette.color(QPalette::Base);
    const QColor ink = palette.color(QPalette::Text);
    const double cell = std::min(
        {size.width() / static_cast<double>(part.width), size.height() / (0.82 * part.height()), 22.0});
    const QSizeF cellSize(cell, 0.82 * cell);
    const QPointF corner((size.width() - cellSize.width() * part.width) / 2,
                         (size.height() - cellSize.height() * part.height()) / 2);
    const auto rectOf = [&](int wale, int course) {
        return QRectF(corner +
                          QPointF(wale * cellSize.width(), (part.height() - 1 - course) * cellSize.height()),
                      cellSize);
    };
    for (int c = 0; c < part.height(); ++c) {
        for (int w = 0; w < part.width; ++w) {
            const bool rear = part.at(w, c).stitch == Stitch::Purl;
            painter.fillRect(rectOf(w, c), rear ? palette.color(QPalette::AlternateBase).darker(112) : base);
        }
    }
    for (int c = 0; c < part.height(); ++c) {
        for (int w = 0; w < part.width && cell >= 5; ++w) {
            const bool moved = std::ranges::any_of(
                part.course(c).moves, [&](const auto& move) { return move.from == w || move.to == w; });
            if (!moved) {
                paintStitch(painter, rectOf(w, c), part.at(w, c).stitch, ink);
            }
        }
        paintMoves(
            painter, part.course(c).moves, [&](int wale) { return rectOf(wale, c); }, ink, base);
    }
    painter.setRenderHint(QPainter::Antialiasing, false);
    painter.setPen(accentsOf(palette).line);
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(QRectF(corner, QSizeF(cellSize.width() * part.width, cellSize.height() * part.height()))
                         .adjusted(0, 0, -1, -1));
    return pixmap;
}

QString stitchName(Stitch stitch) {
    const auto tr = [](const char* text) { return QCoreApplication::translate("Stitch", text); };
    switch (stitch) {
    case Stitch::Knit:
        return tr("Knit: stitch on the front bed");
    case Stitch::Purl:
        return tr("Purl: stitch on the rear bed");
    case Stitch::Both:
        return tr("Stitch on both beds");
    case Stitch::Tuck:
        return tr("Tuck: the yarn is laid into the hook, the loop is held");
    case Stitch::Miss:
        return tr("Miss: the yarn passes, the loop is held");
    case Stitch::Rest:
        return tr("Rest: the yarn does not come here, the loop is held");
    case Stitch::Empty:
        return tr("Empty: no fabric here");
    }
    return {};
}

} // namespace knittsim::ui
