#include "ui/views/fabric_view/overlay.h"

#include "ui/views/fabric_view/marker_painter.h"

#include <QLocale>
#include <QPainter>

#include <algorithm>
#include <array>
#include <cmath>

namespace knittsim::ui {

namespace {

constexpr int kMargin = 12;
constexpr double kScalePixels = 140;
constexpr float kSeenFlat = 0.15F; ///< cosine to the fabric's normal below which neither face is seen

QColor opaque(QColor colour) {
    colour.setAlpha(255);
    return colour;
}

} // namespace

double scaleBarMm(double millimetresPerPixel, double mostPixels) {
    const double most = millimetresPerPixel * mostPixels;
    if (!(most > 0) || !std::isfinite(most)) {
        return 1;
    }
    const double power = std::pow(10, std::floor(std::log10(most)));
    return most >= 5 * power ? 5 * power : most >= 2 * power ? 2 * power : power;
}

Overlay::Overlay(QWidget* parent, const CanvasContent& content) : QWidget(parent), m_content(content) {
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setAttribute(Qt::WA_NoSystemBackground);
    setFocusPolicy(Qt::NoFocus);
}

void Overlay::setMessage(const QString& message) {
    m_message = message;
    update();
}

QString Overlay::sideText() const {
    const float facing = m_content.camera.towardsViewer().z();
    return facing > kSeenFlat ? tr("technical face") : facing < -kSeenFlat ? tr("technical back") : QString();
}

QColor Overlay::ink() const {
    return m_content.dark ? QColor(235, 237, 240) : QColor(32, 36, 42);
}

QColor Overlay::ground() const {
    return m_content.dark ? QColor(20, 22, 25, 215) : QColor(255, 255, 255, 215);
}

void Overlay::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    if (m_content.scene) {
        paintFlags(painter);
        paintPins(painter);
        paintMark(painter);
        paintPull(painter);
        paintBadge(painter);
        // Below the badge, which may be missing; so the legends do not jump when the fabric is turned.
        int top = kMargin + fontMetrics().height() + 16;
        if (m_content.legend && m_content.scene->style == render::DrawStyle::Mesh) {
            top = paintLegend(painter, top);
        }
        if (m_content.colourBy != render::ColourBy::Yarn) {
            paintColours(painter, top);
        }
        paintScale(painter);
        paintAxes(painter);
    }
    paintMessage(painter);
}

void Overlay::paintBadge(QPainter& painter) const {
    const QString text = sideText();
    if (text.isEmpty()) {
        return;
    }
    const QSize size = fontMetrics().size(Qt::TextSingleLine, text);
    const QRect box(kMargin, kMargin, size.width() + 20, size.height() + 8);
    painter.setPen(Qt::NoPen);
    painter.setBrush(ground());
    painter.drawRoundedRect(box, box.height() / 2.0, box.height() / 2.0);
    painter.setPen(ink());
    painter.drawText(box, Qt::AlignCenter, text);
}

/// Returns where there is room below it.
int Overlay::paintLegend(QPainter& painter, int top) const {
    struct Row {
        render::Marker::Kind kind;
        QString text;
    };
    const std::array rows{Row{render::Marker::Bond, tr("foot in a head: a loop drawn through")},
                          Row{render::Marker::OpenHead, tr("head, nothing through it")},
                          Row{render::Marker::Crossing, tr("crossing: the unbroken yarn lies in front")}};
    constexpr int kSymbol = 34;
    const int height = fontMetrics().height() + 4;
    int width = 0;
    for (const Row& row : rows) {
        width = std::max(width, fontMetrics().horizontalAdvance(row.text));
    }
    const QRect box(kMargin, top, kSymbol + width + 16, static_cast<int>(rows.size()) * height + 10);
    painter.setPen(Qt::NoPen);
    painter.setBrush(ground());
    painter.drawRoundedRect(box, 8, 8);
    QPointF centre(box.left() + kSymbol / 2.0 + 2, box.top() + 5 + height / 2.0);
    for (const Row& row : rows) {
        painter.setPen(QPen(ink(), 1.4));
        const QPointF across(row.kind == render::Marker::Crossing ? 6 : 12,
                             row.kind == render::Marker::Crossing ? -8 : 0);
        painter.drawLine(centre - across, centre + across);
        paintMarker(painter, row.kind, centre, 10, {1, 0.25}, opaque(ground()), m_content.dark);
        painter.setPen(ink());
        painter.drawText(QPointF(box.left() + kSymbol + 6, centre.y() + fontMetrics().ascent() / 2.0 - 1),
                         row.text);
        centre.ry() += height;
    }
    return box.bottom() + 9;
}

/// The colours of values from low to high, with round numbers below them.
void Overlay::paintColours(QPainter& painter, int top) const {
    constexpr int kBarWidth = 176;
    constexpr int kBarHeight = 12;
    const render::ValueRange& range = m_content.scene->range;
    const QString what = m_content.colourBy == render::ColourBy::Tension ? tr("Yarn tension (mN)")
                                                                         : tr("Contact force (mN/mm)");
    const QString none = tr("Not known for this shape yet");
    const int line = fontMetrics().height();
    const int inner = std::max({kBarWidth, fontMetrics().horizontalAdvance(what),
                                range.empty() ? fontMetrics().horizontalAdvance(none) : 0});
    const QRect box(kMargin, top, inner + 40, range.empty() ? 2 * line + 12 : 2 * line + kBarHeight + 22);
    painter.setPen(Qt::NoPen);
    painter.setBrush(ground());
    painter.drawRoundedRect(box, 8, 8);
    painter.setPen(ink());
    const int left = box.left() + 20;
    painter.drawText(left, box.top() + 5 + fontMetrics().ascent(), what);
    if (range.empty()) {
        painter.drawText(left, box.top() + 5 + line + fontMetrics().ascent(), none);
        return;
    }
    const QRect bar(left, box.top() + 9 + line, kBarWidth, kBarHeight);
    QLinearGradient colours(bar.topLeft(), bar.topRight());
    for (std::size_t i = 0; i < render::kRampColours; ++i) {
        const yarn::Colour& c = render::ramp()[i];
        colours.setColorAt(static_cast<double>(i) / (render::kRampColours - 1), QColor(c.r, c.g, c.b));
    }
    painter.fillRect(bar, colours);
    const auto steps = static_cast<int>(std::lround((range.high - range.low) / range.step));
    for (int tick = 0; tick <= steps; ++tick) {
        const float value = range.low + static_cast<float>(tick) * range.step;
        const int x =
            bar.left() + static_cast<int>(range.shareOf(value) * static_cast<float>(bar.width() - 1));
        painter.drawLine(x, bar.bottom() + 1, x, bar.bottom() + 4);
        painter.drawText(QRect(x - 50, bar.bottom() + 5, 100, line), Qt::AlignHCenter | Qt::AlignTop,
                         QLocale().toString(value, 'g', 6));
    }
}

QPointF Overlay::onScreen(const Vec3f& place) const {
    const Vec3f p = m_content.camera.project(place);
    return {p.x(), p.y()};
}

/// A pin with its head above the place that it holds.
void Overlay::paintPins(QPainter& painter) const {
    for (const Vec3f& place : m_content.pins) {
        const QPointF tip = onScreen(place);
        const QPointF head = tip + QPointF(0, -15);
        for (const QPen& pen : {QPen(ground(), 5), QPen(ink(), 2)}) {
            painter.setPen(pen);
            painter.drawLine(tip, head);
        }
        painter.setPen(QPen(ground(), 1.5));
        painter.setBrush(m_content.dark ? QColor(255, 178, 41) : QColor(200, 80, 0));
        painter.drawEllipse(head, 6, 6);
    }
}

/// A spring from the yarn to the mouse.
void Overlay::paintPull(QPainter& painter) const {
    if (!m_content.pull) {
        return;
    }
    constexpr int kTurns = 14;
    constexpr double kWide = 7;
    const QPointF from = onScreen(m_content.pull->first);
    const QPointF to = onScreen(m_content.pull->second);
    const QPointF way = to - from;
    const double length = std::hypot(way.x(), way.y());
    QPolygonF spring{from};
    if (length > 4 * kWide) {
        const QPointF across(-way.y() / length * kWide, way.x() / length * kWide);
        for (int i = 0; i < kTurns; ++i) {
            spring << from + (0.15 + 0.7 * (i + 0.5) / kTurns) * way + (i % 2 == 0 ? across : -across);
        }
    }
    spring << to;
    painter.setBrush(Qt::NoBrush);
    for (const QPen& pen : {QPen(ground(), 4.5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin),
                            QPen(ink(), 2, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin)}) {
        painter.setPen(pen);
        painter.drawPolyline(spring);
    }
    painter.setBrush(ink());
    painter.drawEllipse(to, 4, 4);
}

void Overlay::paintMark(QPainter& painter) const {
    if (!m_content.mark) {
        return;
    }
    const Vec3f place = m_content.camera.project(*m_content.mark);
    painter.setBrush(Qt::NoBrush);
    for (const QPen& pen : {QPen(ground(), 4.5), QPen(ink(), 2)}) {
        painter.setPen(pen);
        painter.drawEllipse(QPointF(place.x(), place.y()), 9, 9);
    }
}

/// A triangle that stands on the stitch, tip down.
void Overlay::paintFlags(QPainter& painter) const {
    constexpr double kSize = 9;
    for (const Flag& flag : m_content.flags) {
        const Vec3f place = m_content.camera.project(flag.place);
        const QPointF tip(place.x(), place.y());
        painter.setPen(QPen(opaque(ground()), 1.5));
        painter.setBrush(flag.colour);
        painter.drawPolygon(
            QPolygonF{{tip, tip + QPointF(-0.6 * kSize, -kSize), tip + QPointF(0.6 * kSize, -kSize)}});
    }
}

void Overlay::paintScale(QPainter& painter) const {
    const double perPixel = m_content.camera.millimetresPerPixel();
    const double millimetres = scaleBarMm(perPixel, std::min(kScalePixels, width() / 3.0));
    const double pixels = millimetres / perPixel;
    const double right = width() - kMargin;
    const double y = height() - kMargin;
    const QString text = tr("%1 mm").arg(QLocale().toString(millimetres, 'g', 6));
    painter.setPen(QPen(ink(), 2));
    painter.drawPolyline(
        QPolygonF({{right - pixels, y - 6}, {right - pixels, y}, {right, y}, {right, y - 6}}));
    painter.drawText(
        QRectF(right - pixels - 100, y - 8 - fontMetrics().height(), pixels + 200, fontMetrics().height()),
        Qt::AlignHCenter, text);
}

void Overlay::paintAxes(QPainter& painter) const {
    constexpr double kLength = 26;
    const QPointF origin(kMargin + kLength, height() - kMargin - kLength);
    struct Axis {
        Vec3f direction;
        QString name;
    };
    for (const Axis& axis : {Axis{Vec3f::UnitX(), tr("course")}, Axis{Vec3f::UnitY(), tr("wale")}}) {
        const double x = axis.direction.dot(m_content.camera.right());
        const double y = axis.direction.dot(m_content.camera.up());
        const double length = std::hypot(x, y);
        if (length < 0.1) {
            continue;
        }
        const QPointF tip = origin + kLength * QPointF(x, -y);
        painter.setPen(QPen(ink(), 1.6, Qt::SolidLine, Qt::RoundCap));
        painter.drawLine(origin, tip);
        const QPointF along(x / length, -y / length);
        const QPointF across(-along.y(), along.x());
        painter.drawPolyline(QPolygonF({tip - 6 * along + 3 * across, tip, tip - 6 * along - 3 * across}));
        const QSizeF size = fontMetrics().size(Qt::TextSingleLine, axis.name);
        QRectF label(QPointF(), size);
        label.moveCenter(tip +
                         QPointF((6 + size.width() / 2) * along.x(), (4 + size.height() / 2) * along.y()));
        label.moveLeft(std::max<double>(2, label.left()));
        painter.drawText(label, Qt::AlignCenter, axis.name);
    }
}

void Overlay::paintMessage(QPainter& painter) const {
    if (m_message.isEmpty()) {
        return;
    }
    const QRect area = rect().adjusted(2 * kMargin, kMargin, -kMargin, -kMargin);
    const bool something = m_content.scene && !m_content.scene->bounds.empty();
    const int where = something ? Qt::AlignTop | Qt::AlignRight : Qt::AlignCenter;
    const QRect text = fontMetrics().boundingRect(area, where | Qt::TextWordWrap, m_message);
    painter.setPen(Qt::NoPen);
    painter.setBrush(ground());
    painter.drawRoundedRect(text.adjusted(-8, -4, 8, 4), 6, 6);
    painter.setPen(ink());
    painter.drawText(text, where | Qt::TextWordWrap, m_message);
}

} // namespace knittsim::ui
