#include "ui/views/chart_editor/stitch_picture.h"

#include "ui/views/pattern_editor/cell_painter.h"
#include "ui/views/style/appearance.h"

#include <QCoreApplication>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <optional>

namespace knittsim::ui {

using document::StitchKind;
using document::StitchMark;
using pattern::Stitch;

namespace {

/// Both needles of the wale: the rear one above, the front one below. A needle without a mark does nothing.
void paintBeds(QPainter& painter, const QRectF& rect, std::optional<StitchKind> rear,
               std::optional<StitchKind> front, SymbolSet symbols, const QColor& ink) {
    const QRectF upper(rect.topLeft(), QSizeF(rect.width(), rect.height() / 2));
    if (rear) {
        paintSymbol(painter, upper, StitchMark{.kind = *rear, .rear = true}, symbols, ink);
    }
    if (front) {
        paintSymbol(painter, upper.translated(0, rect.height() / 2), StitchMark{.kind = *front}, symbols,
                    ink);
    }
}

void paintDrop(QPainter& painter, const QRectF& rect, const QColor& ink) {
    const double half = 0.26 * std::min(rect.width(), rect.height() * 1.2);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(ink, std::max(1.1, 0.19 * half * 2), Qt::SolidLine, Qt::RoundCap));
    for (const double way : {-1.0, 1.0}) {
        painter.drawLine(rect.center() - QPointF(half, way * half),
                         rect.center() + QPointF(half, way * half));
    }
}

} // namespace

void paintStitch(QPainter& painter, const QRectF& rect, Stitch stitch, SymbolSet symbols, const QColor& ink) {
    switch (stitch) {
    case Stitch::Knit:
        return paintSymbol(painter, rect, StitchMark{.kind = StitchKind::Knit}, symbols, ink);
    case Stitch::Purl:
        return paintSymbol(painter, rect, StitchMark{.kind = StitchKind::Knit, .rear = true}, symbols, ink);
    case Stitch::Tuck:
        return paintSymbol(painter, rect, StitchMark{.kind = StitchKind::Tuck}, symbols, ink);
    case Stitch::Both:
        return paintBeds(painter, rect, StitchKind::Knit, StitchKind::Knit, symbols, ink);
    case Stitch::KnitTuck:
        return paintBeds(painter, rect, StitchKind::Tuck, StitchKind::Knit, symbols, ink);
    case Stitch::TuckKnit:
        return paintBeds(painter, rect, StitchKind::Knit, StitchKind::Tuck, symbols, ink);
    case Stitch::TuckBoth:
        return paintBeds(painter, rect, StitchKind::Tuck, StitchKind::Tuck, symbols, ink);
    case Stitch::RearTuck:
        return paintBeds(painter, rect, StitchKind::Tuck, std::nullopt, symbols, ink);
    case Stitch::RearMiss:
        return paintSymbol(painter, QRectF(rect.topLeft(), QSizeF(rect.width(), rect.height() / 2)),
                           NoLoop::Miss, symbols, ink);
    case Stitch::Drop:
        return paintDrop(painter, rect, ink);
    case Stitch::Miss:
        return paintSymbol(painter, rect, NoLoop::Miss, symbols, ink);
    case Stitch::Rest:
        return paintSymbol(painter, rect, NoLoop::Rest, symbols, ink);
    case Stitch::Empty:
        return paintSymbol(painter, rect, NoLoop::Empty, symbols, ink);
    }
}

bool isStacked(const std::vector<pattern::LoopMove>& moves, const pattern::LoopMove& move) {
    return std::ranges::none_of(moves, [&](const pattern::LoopMove& other) { return other.from == move.to; });
}

bool leavesHole(const std::vector<pattern::LoopMove>& moves, const pattern::LoopMove& move) {
    return std::ranges::none_of(moves, [&](const pattern::LoopMove& other) { return other.to == move.from; });
}

namespace {

/// The way of a loop through its course: a curve, or the straight line of the craft's cables.
QPainterPath wayOf(const QRectF& from, const QRectF& to, SymbolSet symbols) {
    QPainterPath path(QPointF(from.center().x(), from.bottom()));
    if (symbols == SymbolSet::Craft) {
        path.lineTo(to.center().x(), to.top());
    } else {
        const double mid = from.center().y();
        path.cubicTo({from.center().x(), mid}, {to.center().x(), mid}, {to.center().x(), to.top()});
    }
    return path;
}

/// A decrease of the craft leans the way that its loop went.
QPainterPath slashOf(const QRectF& cell, bool right) {
    const double half = 0.32 * std::min(cell.width(), cell.height() * 1.2);
    const QPointF up(right ? half : -half, -half);
    QPainterPath path(cell.center() - up);
    path.lineTo(cell.center() + up);
    return path;
}

} // namespace

void paintMoves(QPainter& painter, const std::vector<pattern::LoopMove>& moves,
                const std::function<QRectF(int)>& cellOf, SymbolSet symbols, const QColor& ink,
                const QColor& ground) {
    painter.setRenderHint(QPainter::Antialiasing);
    // The first of two that cross lies in front, so it is drawn last.
    for (auto move = moves.rbegin(); move != moves.rend(); ++move) {
        const QRectF from = cellOf(move->from);
        const QRectF to = cellOf(move->to);
        const bool slash = symbols == SymbolSet::Craft && isStacked(moves, *move);
        const QPainterPath path = slash ? slashOf(to, move->to > move->from) : wayOf(from, to, symbols);
        painter.setBrush(Qt::NoBrush);
        if (!slash) {
            painter.setPen(QPen(ground, std::max(3.0, 0.42 * from.width()), Qt::SolidLine, Qt::FlatCap));
            painter.drawPath(path);
        }
        painter.setPen(QPen(ink, std::max(1.5, 0.16 * from.width()), Qt::SolidLine, Qt::FlatCap));
        painter.drawPath(path);
        if (leavesHole(moves, *move)) {
            const double radius = 0.24 * std::min(from.width(), from.height());
            painter.setPen(QPen(ink, std::max(1.2, 0.1 * from.width())));
            painter.setBrush(ground);
            painter.drawEllipse(from.center(), radius, radius);
        }
    }
}

QPixmap pictureOf(const pattern::Chart& part, const QSize& size, double ratio, const QPalette& palette,
                  SymbolSet symbols) {
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
                paintStitch(painter, rectOf(w, c), part.at(w, c).stitch, symbols, ink);
            }
        }
        paintMoves(
            painter, part.course(c).moves, [&](int wale) { return rectOf(wale, c); }, symbols, ink, base);
    }
    painter.setRenderHint(QPainter::Antialiasing, false);
    painter.setPen(accentsOf(palette).line);
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(QRectF(corner, QSizeF(cellSize.width() * part.width, cellSize.height() * part.height()))
                         .adjusted(0, 0, -1, -1));
    return pixmap;
}

QString stitchName(Stitch stitch) {
    const auto tr = [](const char* text) { return QCoreApplication::translate("knittsim::ui", text); };
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
    case Stitch::KnitTuck:
        return tr("Knit on the front bed, tuck on the rear bed");
    case Stitch::TuckKnit:
        return tr("Tuck on the front bed, knit on the rear bed");
    case Stitch::TuckBoth:
        return tr("Tuck on both beds");
    case Stitch::RearTuck:
        return tr("Tuck on the rear bed");
    case Stitch::RearMiss:
        return tr("Miss on the rear bed");
    case Stitch::Drop:
        return tr("Drop: the loops of the needle fall off before the course");
    }
    return {};
}

} // namespace knittsim::ui
