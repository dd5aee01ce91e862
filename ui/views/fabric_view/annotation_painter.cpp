#include "ui/views/fabric_view/annotation_painter.h"

#include "ui/render/look.h"

#include <QCoreApplication>
#include <QLocale>
#include <QPainter>
#include <QPainterPath>
#include <QStringList>

#include <algorithm>
#include <array>
#include <cmath>

namespace knittsim::ui {

namespace {

constexpr double kInchMm = 25.4;
constexpr float kSeenFlat = 0.5F; ///< cosine to the fabric's normal below which its width is not told
constexpr double kGuidePixels = 44;

QPointF onScreen(const CanvasContent& content, const Vec3f& place) {
    const Vec3f p = content.camera.project(place);
    return {p.x(), p.y()};
}

QColor toQt(yarn::Colour c) {
    return {c.r, c.g, c.b};
}

/// Text on a ground of its own.
void paintLabel(QPainter& painter, QPointF centre, const QString& text, const QColor& ink,
                const QColor& ground) {
    QRectF box(QPointF(), painter.fontMetrics().size(Qt::TextSingleLine, text) + QSize(10, 2));
    box.moveCenter(centre);
    painter.setPen(Qt::NoPen);
    painter.setBrush(ground);
    painter.drawRoundedRect(box, 4, 4);
    painter.setPen(ink);
    painter.drawText(box, Qt::AlignCenter, text);
}

/// A line with a bar at both ends, in two widths so that it is seen on yarn too.
void paintMeasure(QPainter& painter, QPointF from, QPointF to, const OverlayInk& ink) {
    const QPointF way = to - from;
    const double length = std::hypot(way.x(), way.y());
    if (length < 1) {
        return;
    }
    const QPointF across = 5 / length * QPointF(-way.y(), way.x());
    for (const QPen& pen : {QPen(ink.ground, 4), QPen(ink.ink, 1.4)}) {
        painter.setPen(pen);
        painter.drawLine(from, to);
        painter.drawLine(from - across, from + across);
        painter.drawLine(to - across, to + across);
    }
}

/// One dimension along the edge from `a` to `b`, beside it on the side away from `middle`, and always inside
/// the picture. Of `texts` the first one that is not longer than the edge, else the last one.
void paintEdge(QPainter& painter, QSize size, QPointF a, QPointF b, QPointF middle, const QStringList& texts,
               const OverlayInk& ink) {
    constexpr double kAway = 16;
    constexpr double kMargin = 14;
    const QPointF way = b - a;
    const double length = std::hypot(way.x(), way.y());
    if (length < 30) {
        return; // no room
    }
    QPointF out = 1 / length * QPointF(-way.y(), way.x());
    if (QPointF::dotProduct(out, 0.5 * (a + b) - middle) < 0) {
        out = -out;
    }
    const QPointF centre = 0.5 * (a + b) + kAway * out;
    const bool upright = std::abs(way.y()) > std::abs(way.x());
    const auto fits = [&](const QString& text) {
        return painter.fontMetrics().horizontalAdvance(text) <= length;
    };
    const auto found = std::find_if(texts.begin(), texts.end(), fits);
    const QString& text = found == texts.end() ? texts.back() : *found;
    const double half = 0.5 * painter.fontMetrics().horizontalAdvance(text) + kMargin;
    const auto inside = [](double value, double margin, double end) {
        return std::clamp(value, std::min(margin, end / 2), std::max(end - margin, end / 2));
    };
    const QPointF label(inside(centre.x(), upright ? kMargin : half, size.width()),
                        inside(centre.y(), upright ? half : kMargin, size.height()));
    // The line moves only across; its ends stay those of the fabric.
    const QPointF moved = QPointF::dotProduct(label - centre, out) * out;
    paintMeasure(painter, a + kAway * out + moved, b + kAway * out + moved, ink);
    painter.save();
    painter.translate(label);
    if (upright) {
        painter.rotate(-90);
    }
    paintLabel(painter, {}, text, ink.ink, ink.ground);
    painter.restore();
}

/// "22.2 mm (0.87 in), 140 wales in 10 cm", where the spacing is known, and shorter ones.
QStringList dimensionTexts(double millimetres, double spacingMm, const QString& gauge) {
    constexpr double kGaugeMm = 100;
    QStringList texts{lengthText(millimetres),
                      QCoreApplication::translate("knittsim::ui::FabricView", "%1 mm")
                          .arg(QLocale().toString(millimetres, 'f', millimetres < 100 ? 1 : 0))};
    if (spacingMm > 0) {
        texts.prepend(QStringLiteral("%1 \u00b7 %2")
                          .arg(texts.front(), gauge.arg(QLocale().toString(kGaugeMm / spacingMm, 'f', 1))));
    }
    return texts;
}

} // namespace

QString lengthText(double millimetres) {
    return QCoreApplication::translate("knittsim::ui::FabricView", "%1 mm (%2 in)")
        .arg(QLocale().toString(millimetres, 'f', 1), QLocale().toString(millimetres / kInchMm, 'f', 2));
}

OverlayInk overlayInk(bool dark) {
    const render::MeshColours colours = render::meshColours(dark);
    return dark ? OverlayInk{QColor(235, 237, 240), QColor(20, 22, 25, 215), toQt(colours.foot),
                             toQt(colours.head),    QColor(176, 184, 194),   QColor(112, 120, 130)}
                : OverlayInk{QColor(32, 36, 42), QColor(255, 255, 255, 215), toQt(colours.foot),
                             toQt(colours.head), QColor(96, 104, 114),       QColor(150, 158, 168)};
}

void paintDimensions(QPainter& painter, QSize size, const CanvasContent& content,
                     const Annotations& annotations, const OverlayInk& ink) {
    const geometry::Bounds& box = content.scene->bounds;
    if (box.empty() || std::abs(content.camera.towardsViewer().z()) < kSeenFlat) {
        return;
    }
    const float z = box.centre().z();
    const auto corner = [&](float x, float y) { return onScreen(content, {x, y, z}); };
    const QPointF middle = onScreen(content, box.centre());
    const geometry::Measurement measured = annotations.size.value_or(geometry::Measurement());
    paintEdge(painter, size, corner(box.low.x(), box.low.y()), corner(box.high.x(), box.low.y()), middle,
              dimensionTexts(box.size().x(), measured.waleSpacingMm,
                             QCoreApplication::translate("knittsim::ui::FabricView", "%1 wales in 10 cm")),
              ink);
    // On the left of the picture, whichever side is seen.
    const float left = content.camera.towardsViewer().z() > 0 ? box.low.x() : box.high.x();
    paintEdge(painter, size, corner(left, box.low.y()), corner(left, box.high.y()), middle,
              dimensionTexts(box.size().y(), measured.courseSpacingMm,
                             QCoreApplication::translate("knittsim::ui::FabricView", "%1 courses in 10 cm")),
              ink);
}

int guideStep(double spacingMm, double millimetresPerPixel) {
    if (!(spacingMm > 0) || !(millimetresPerPixel > 0)) {
        return 1;
    }
    const double least = kGuidePixels * millimetresPerPixel / spacingMm;
    int step = 1;
    for (int i = 0; step < least && i < 15; ++i) {
        step = i % 3 == 1 ? step * 5 / 2 : step * 2;
    }
    return step;
}

void paintGuides(QPainter& painter, const CanvasContent& content, const Annotations& annotations,
                 const OverlayInk& ink) {
    if (!annotations.lattice || !annotations.size) {
        return;
    }
    const geometry::StitchLattice& lattice = *annotations.lattice;
    const double perPixel = content.camera.millimetresPerPixel();
    const auto paint = [&](int lines, int length, int step, const QColor& colour, const auto& placeAt) {
        for (int line = 0; line < lines; ++line) {
            const int number = line + 1;
            if (number % step != 0 && number != 1) {
                continue;
            }
            QPolygonF polygon;
            for (int i = 0; i < length; ++i) {
                if (const std::optional<Vec3f>& place = placeAt(line, i)) {
                    polygon << onScreen(content, *place);
                }
            }
            if (polygon.size() < 2) {
                continue;
            }
            painter.setBrush(Qt::NoBrush);
            for (const QPen& pen : {QPen(ink.ground, 3), QPen(colour, 1.5)}) {
                painter.setPen(pen);
                painter.drawPolyline(polygon);
            }
            paintLabel(painter, polygon.back(), QLocale().toString(number), colour, ink.ground);
        }
    };
    paint(
        lattice.courses, lattice.wales, guideStep(annotations.size->courseSpacingMm, perPixel),
        ink.course, [&](int course, int wale) -> const auto& { return lattice.at(wale, course); });
    paint(
        lattice.wales, lattice.courses, guideStep(annotations.size->waleSpacingMm, perPixel),
        ink.wale, [&](int wale, int course) -> const auto& { return lattice.at(wale, course); });
}

void paintProblems(QPainter& painter, const CanvasContent& content, const Annotations& annotations) {
    constexpr double kRadius = 9;
    QFont bold = painter.font();
    bold.setBold(true);
    painter.save();
    painter.setFont(bold);
    for (const Annotations::Mark& mark : annotations.problems) {
        const QPointF centre = onScreen(content, mark.place);
        const bool error = mark.severity == Severity::Error;
        const bool warning = mark.severity == Severity::Warning;
        painter.setPen(QPen(QColor(255, 255, 255), 1.6));
        painter.setBrush(error ? QColor(190, 30, 30) : warning ? QColor(150, 90, 0) : QColor(40, 90, 160));
        painter.drawEllipse(centre, kRadius, kRadius);
        painter.setPen(Qt::white);
        painter.drawText(QRectF(centre.x() - kRadius, centre.y() - kRadius, 2 * kRadius, 2 * kRadius),
                         Qt::AlignCenter,
                         error     ? QStringLiteral("\u00d7")
                         : warning ? QStringLiteral("!")
                                   : QStringLiteral("i"));
    }
    painter.restore();
}

void paintNeedles(QPainter& painter, const CanvasContent& content, const Annotations& annotations,
                  const OverlayInk& ink) {
    const QFontMetricsF metrics(painter.font());
    const double apart = metrics.horizontalAdvance(QStringLiteral("b888")) + 4;
    const double line = metrics.height() + 3;
    std::vector<const fabric::NeedleHook*> order;
    for (const fabric::NeedleHook& hook : annotations.needles) {
        order.push_back(&hook);
    }
    const Vec3f towards = content.camera.towardsViewer();
    std::ranges::stable_sort(order, {},
                             [&](const fabric::NeedleHook* hook) { return hook->place.dot(towards); });
    for (const fabric::NeedleHook* hook : order) {
        const QPointF end = onScreen(content, hook->place + hook->shaft);
        const QPointF place = onScreen(content, hook->place);
        const double size = 0.055 * std::hypot((end - place).x(), (end - place).y());
        const bool front = machine::isFront(hook->needle.bed);
        const double width = std::clamp(size, 1.2, 5.0);
        // The hook bends to the viewer's right, below the yarn it holds.
        QPainterPath path(end);
        path.lineTo(place + QPointF(-1.6 * size, 0));
        path.cubicTo(place + QPointF(-1.6 * size, 3.2 * size), place + QPointF(1.6 * size, 3.2 * size),
                     place + QPointF(1.6 * size, -0.6 * size));
        painter.setBrush(Qt::NoBrush);
        const QColor steel = hook->works ? ink.wale : front ? ink.needle : ink.rearNeedle;
        for (const QPen& pen : {QPen(ink.ground, width + 2.4, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin),
                                QPen(steel, width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin)}) {
            painter.setPen(pen);
            painter.drawPath(path);
        }
    }
    // The needles that work are named first; of the others those that have room beside them.
    std::ranges::stable_sort(order, {}, [](const fabric::NeedleHook* hook) { return !hook->works; });
    std::array<std::vector<double>, 2> named; // places across, by bed
    for (const fabric::NeedleHook* hook : order) {
        const QPointF end = onScreen(content, hook->place + hook->shaft);
        const bool front = machine::isFront(hook->needle.bed);
        std::vector<double>& taken = named[front ? 0 : 1];
        if (!hook->works &&
            std::ranges::any_of(taken, [&](double x) { return std::abs(end.x() - x) < apart; })) {
            continue;
        }
        taken.push_back(end.x());
        // Rear needles are named in a line above the front ones; the upper edge of the picture cuts none.
        const double y = std::max(end.y() - (front ? 0.5 : 1.5) * line, (front ? 1.5 : 0.5) * line);
        paintLabel(painter, {end.x(), y}, QString::fromStdString(machine::toString(hook->needle)),
                   hook->works ? ink.wale : ink.ink, ink.ground);
    }
}

void paintTape(QPainter& painter, const CanvasContent& content, const Annotations& annotations,
               const OverlayInk& ink) {
    if (annotations.tape.empty()) {
        return;
    }
    const Vec3f from = annotations.tape.front();
    const std::optional<Vec3f> to =
        annotations.tape.size() > 1 ? std::optional(annotations.tape.back()) : annotations.tapeEnd;
    const QPointF start = onScreen(content, from);
    painter.setPen(QPen(ink.ground, 2));
    painter.setBrush(ink.ink);
    painter.drawEllipse(start, 4, 4);
    if (to) {
        const QPointF end = onScreen(content, *to);
        paintMeasure(painter, start, end, ink);
        paintLabel(painter, 0.5 * (start + end) + QPointF(0, -16), lengthText((*to - from).norm()), ink.ink,
                   ink.ground);
    }
}

} // namespace knittsim::ui
