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
constexpr int kGap = 6;     ///< between words and legends
constexpr int kSample = 24; ///< line before a word
constexpr int kSymbol = 34; ///< of a legend
constexpr int kBarWidth = 176;
constexpr int kBarHeight = 12;
constexpr double kScalePixels = 140;
constexpr int kLeastForAxes = 400; ///< width of the view
constexpr float kSeenFlat = 0.15F; ///< cosine to the fabric's normal below which neither face is seen

QColor opaque(QColor colour) {
    colour.setAlpha(255);
    return colour;
}

struct LegendRow {
    render::Marker::Kind kind;
    QString text;
};

std::array<LegendRow, 3> legendRows() {
    return {LegendRow{render::Marker::Bond, Overlay::tr("foot in a head: a loop drawn through")},
            LegendRow{render::Marker::OpenHead, Overlay::tr("head, nothing through it")},
            LegendRow{render::Marker::Crossing, Overlay::tr("crossing: the unbroken yarn lies in front")}};
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

Overlay::Overlay(QWidget* parent, const CanvasContent& content, const Annotations& annotations)
    : QWidget(parent), m_content(content), m_annotations(annotations) {
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
    return facing > kSeenFlat    ? tr("technical face")
           : facing < -kSeenFlat ? tr("technical back")
                                 : tr("seen from its edge");
}

std::vector<Overlay::Word> Overlay::words() const {
    std::vector<Word> words;
    if (!m_annotations.notice.isEmpty()) {
        words.push_back({m_annotations.notice});
    }
    if (m_annotations.guides) {
        const OverlayInk colours = overlayInk(m_content.dark);
        words.push_back({tr("courses, numbered"), colours.course});
        words.push_back({tr("wales, numbered"), colours.wale});
    }
    if (m_annotations.marks && !m_annotations.problems.empty()) {
        words.push_back({tr("\u00d7 error, ! warning")});
    }
    if (!m_annotations.alone.isEmpty()) {
        words.push_back({m_annotations.alone});
    }
    if (m_content.section) {
        words.push_back({tr("section: Alt and wheel move it")});
    }
    if (m_annotations.alignClicks >= 0) {
        const std::array texts{
            tr("click a point of the photograph"), tr("click the same point of the fabric"),
            tr("click a second point of the photograph"), tr("click the second point of the fabric")};
        words.push_back({texts[static_cast<std::size_t>(m_annotations.alignClicks)]});
    } else if (m_annotations.photograph.visible()) {
        words.push_back(
            {m_annotations.photograph.beside ? tr("photograph beside") : tr("photograph over it")});
    }
    if (m_annotations.taping) {
        words.push_back({m_annotations.tape.size() == 1 ? tr("tape: click the second point")
                                                        : tr("tape: click the first point")});
    }
    return words;
}

void Overlay::paintEvent(QPaintEvent*) {
    if (m_prepare) {
        m_prepare();
    }
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    if (m_content.scene) {
        paintPhoto(painter);
        const OverlayInk colours = overlayInk(m_content.dark);
        if (m_annotations.guides) {
            paintGuides(painter, m_content, m_annotations, colours);
        }
        if (m_annotations.dimensions && m_annotations.measures) {
            paintDimensions(painter, size(), m_content, m_annotations, colours);
        }
        paintNeedles(painter, m_content, m_annotations, colours);
        if (m_annotations.marks) {
            paintProblems(painter, m_content, m_annotations);
        }
        paintTape(painter, m_content, m_annotations, colours);
        paintPins(painter);
        paintMark(painter);
        paintPull(painter);
        paintHead(painter);
        if (m_annotations.measures) {
            paintScale(painter);
            paintAxes(painter);
        }
    }
    paintMessage(painter);
}

/// While it is aligned it is seen alone, or not at all.
void Overlay::paintPhoto(QPainter& painter) const {
    Photograph photograph = m_annotations.photograph;
    if (m_annotations.alignClicks >= 0) {
        photograph.opacity = 1;
        photograph.wipe = 0;
        photograph.shown = photograph.beside || m_annotations.alignClicks % 2 == 0;
    }
    paintPhotograph(painter, size(), m_content, photograph);
}

Overlay::Head Overlay::layOut() const {
    const int height = fontMetrics().height() + 8;
    std::vector<Word> all = words();
    all.insert(all.begin(), {sideText()});
    Head head;
    QPoint corner(kMargin, kMargin);
    for (const Word& word : all) {
        const int sample = word.sample.isValid() ? kSample : 0;
        const QSize size(fontMetrics().horizontalAdvance(word.text) + 20 + sample, height);
        if (corner.x() > kMargin && corner.x() + size.width() > width() - kMargin) {
            corner = {kMargin, corner.y() + height + kGap};
        }
        head.words.push_back({QRect(corner, size), word});
        corner.rx() += size.width() + kGap;
    }
    head.height = corner.y() + height + kGap;
    const auto below = [&head](const QSize& size) {
        const QRect box({kMargin, head.height}, size);
        head.height += size.isEmpty() ? 0 : size.height() + kGap;
        return box;
    };
    head.legend = below(legendSize());
    head.colours = below(coloursSize());
    return head;
}

int Overlay::headHeight() const {
    return layOut().height;
}

void Overlay::paintHead(QPainter& painter) const {
    const Head head = layOut();
    painter.save();
    if (!m_annotations.measures) {
        painter.translate(0, height() - head.height); // a class sees needles above
    }
    for (const WordBox& box : head.words) {
        paintWord(painter, box);
    }
    if (!head.legend.isEmpty()) {
        paintLegend(painter, head.legend);
    }
    if (!head.colours.isEmpty()) {
        paintColours(painter, head.colours);
    }
    painter.restore();
}

void Overlay::paintWord(QPainter& painter, const WordBox& box) const {
    const auto& [place, word] = box;
    painter.setPen(Qt::NoPen);
    painter.setBrush(ground());
    painter.drawRoundedRect(place, place.height() / 2.0, place.height() / 2.0);
    const int sample = word.sample.isValid() ? kSample : 0;
    if (sample > 0) {
        painter.setPen(QPen(word.sample, 2));
        painter.drawLine(place.left() + 10, place.center().y(), place.left() + sample + 2,
                         place.center().y());
    }
    painter.setPen(ink());
    painter.drawText(place.adjusted(sample, 0, 0, 0), Qt::AlignCenter, word.text);
}

QSize Overlay::legendSize() const {
    if (!m_content.legend || !m_content.scene || m_content.scene->style != render::DrawStyle::Mesh) {
        return {};
    }
    int width = 0;
    for (const LegendRow& row : legendRows()) {
        width = std::max(width, fontMetrics().horizontalAdvance(row.text));
    }
    return {kSymbol + width + 16, static_cast<int>(legendRows().size()) * (fontMetrics().height() + 4) + 10};
}

void Overlay::paintLegend(QPainter& painter, const QRect& box) const {
    const int height = fontMetrics().height() + 4;
    painter.setPen(Qt::NoPen);
    painter.setBrush(ground());
    painter.drawRoundedRect(box, 8, 8);
    QPointF centre(box.left() + kSymbol / 2.0 + 2, box.top() + 5 + height / 2.0);
    for (const LegendRow& row : legendRows()) {
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
}

QString Overlay::coloursTitle() const {
    return m_content.colourBy == render::ColourBy::Tension ? tr("Yarn tension (mN)")
           : m_content.colourBy == render::ColourBy::Speed ? tr("Moved since the last picture (mm)")
                                                           : tr("Contact force (mN/mm)");
}

QString Overlay::noColoursReason() const {
    return m_content.colourBy == render::ColourBy::Speed ? tr("Nothing has moved")
                                                         : tr("Not known for this shape yet");
}

QSize Overlay::coloursSize() const {
    if (m_content.colourBy == render::ColourBy::Yarn || !m_content.scene) {
        return {};
    }
    const bool none = m_content.scene->range.empty();
    const int line = fontMetrics().height();
    const int inner = std::max({kBarWidth, fontMetrics().horizontalAdvance(coloursTitle()),
                                none ? fontMetrics().horizontalAdvance(noColoursReason()) : 0});
    return {inner + 40, none ? 2 * line + 12 : 2 * line + kBarHeight + 22};
}

/// The colours of values from low to high, with round numbers below them.
void Overlay::paintColours(QPainter& painter, const QRect& box) const {
    const render::ValueRange& range = m_content.scene->range;
    const int line = fontMetrics().height();
    painter.setPen(Qt::NoPen);
    painter.setBrush(ground());
    painter.drawRoundedRect(box, 8, 8);
    painter.setPen(ink());
    const int left = box.left() + 20;
    painter.drawText(left, box.top() + 5 + fontMetrics().ascent(), coloursTitle());
    if (range.empty()) {
        painter.drawText(left, box.top() + 5 + line + fontMetrics().ascent(), noColoursReason());
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

/// A spring from the yarn to a handle above the mouse, which has a length even where the yarn has followed.
void Overlay::paintPull(QPainter& painter) const {
    if (!m_content.pull) {
        return;
    }
    constexpr int kTurns = 9;
    constexpr double kWide = 8;
    constexpr QPointF kAtRest(30, -42);
    const QPointF from = onScreen(m_content.pull->first);
    const QPointF to = onScreen(m_content.pull->second) + kAtRest;
    const QPointF way = to - from;
    const double length = std::max(1.0, std::hypot(way.x(), way.y()));
    const QPointF across(-way.y() / length * kWide, way.x() / length * kWide);
    QPolygonF spring{from};
    for (int i = 0; i < kTurns; ++i) {
        spring << from + (0.15 + 0.7 * (i + 0.5) / kTurns) * way + (i % 2 == 0 ? across : -across);
    }
    spring << to;
    painter.setBrush(Qt::NoBrush);
    for (const QPen& pen : {QPen(ground(), 4.5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin),
                            QPen(ink(), 1.6, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin)}) {
        painter.setPen(pen);
        painter.drawPolyline(spring);
    }
    painter.setBrush(ink());
    painter.drawEllipse(from, 3, 3);
    painter.drawEllipse(to, 5, 5);
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

void Overlay::paintScale(QPainter& painter) const {
    const double perPixel = m_content.camera.millimetresPerPixel();
    const double millimetres = scaleBarMm(perPixel, std::min(kScalePixels, width() / 3.0));
    const double pixels = millimetres / perPixel;
    const double right = width() - kMargin;
    const double y = height() - kMargin;
    constexpr double kInchMm = 25.4;
    const QString text =
        tr("%1 mm (%2 in)")
            .arg(QLocale().toString(millimetres, 'g', 6), QLocale().toString(millimetres / kInchMm, 'g', 2));
    const QPolygonF bar({{right - pixels, y - 6}, {right - pixels, y}, {right, y}, {right, y - 6}});
    painter.setBrush(Qt::NoBrush);
    for (const QPen& pen : {QPen(ground(), 5), QPen(ink(), 2)}) { // the fabric may lie behind
        painter.setPen(pen);
        painter.drawPolyline(bar);
    }
    QRectF label(QPointF(), QSizeF(fontMetrics().size(Qt::TextSingleLine, text)));
    label.moveCenter({right - pixels / 2, y - 8 - fontMetrics().height() / 2.0});
    label.moveRight(std::min(label.right(), right)); // a short bar stands at the rim
    paintLabel(painter, label, text);
}

void Overlay::paintAxes(QPainter& painter) const {
    if (width() < kLeastForAxes) {
        return; // they would lie on the dimensions
    }
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
        paintLabel(painter, label, axis.name); // a dimension may pass here
    }
}

void Overlay::paintLabel(QPainter& painter, const QRectF& rect, const QString& text) const {
    painter.setPen(Qt::NoPen);
    painter.setBrush(ground());
    painter.drawRoundedRect(rect.adjusted(-3, 0, 3, 0), 4, 4);
    painter.setPen(ink());
    painter.drawText(rect, Qt::AlignCenter, text);
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
