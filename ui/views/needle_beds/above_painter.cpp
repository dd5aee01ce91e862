#include "ui/views/needle_beds/above_painter.h"

#include "core/machine/needle_stroke.h"
#include "ui/views/style/appearance.h"

#include <algorithm>
#include <cmath>

namespace knittsim::ui {

using machine::Bed;
using machine::LoopPlace;
using machine::SeenNeedle;

namespace {

constexpr double kLeastPitchWithLoops = 7; ///< below, a loop is a dot
constexpr double kLeastPitchWithHooks = 12;
constexpr double kSliderRest = 0.45; ///< of a bed's height, from the verge

/// Numbers stand so far apart that they do not touch.
int numberStep(double pitch, double width) {
    for (const int step : {1, 2, 5, 10, 20, 50, 100, 200, 500}) {
        if (step * pitch >= width) {
            return step;
        }
    }
    return 1000;
}

double blend(double from, double to, double t) {
    return from + (to - from) * t;
}

} // namespace

AbovePainter::AbovePainter(QPainter& painter, const BedLayout& layout, const BedScene& scene)
    : m_painter(painter), m_layout(layout), m_scene(scene), m_colours(scene.palette) {
    for (const machine::SeenCarrier& carrier : scene.picture.carriers) {
        m_rails.push_back(carrier.rail);
    }
    std::ranges::sort(m_rails);
    m_rails.erase(std::unique(m_rails.begin(), m_rails.end()), m_rails.end());
    placeLoops();
    placeFlight();
}

/// A slider at rest lies on its bed, behind the hooks.
double AbovePainter::tipOf(const SeenNeedle& needle) const {
    const double back = machine::isSlider(needle.needle.bed) ? kSliderRest * m_layout.bedHeight() : 0;
    return m_layout.stroke() * needle.height - back * (1 - needle.height);
}

void AbovePainter::placeLoops() {
    const double width = m_layout.yarnWidth();
    for (const SeenNeedle& needle : m_scene.picture.needles) {
        double stacked = 0;
        for (const machine::SeenLoop& loop : needle.loops) {
            LoopForm form;
            form.bed = needle.needle.bed;
            form.pitches = needle.pitches;
            form.carrier = loop.carrier;
            form.drawn = loop.drawn;
            form.crossing = tipOf(needle) - m_layout.hook() - m_layout.stroke() * loop.slide + stacked;
            if (loop.place == LoopPlace::KnockedOver) {
                form.crossing = m_layout.hook();
            }
            form.legs = std::max(form.crossing, -m_layout.hook()) + 2.2 * m_layout.hook();
            form.halfWidth = std::min(0.34 * m_layout.pitch, 0.16 * m_layout.gap());
            m_loops[loop.loop] = form;
            stacked += 1.15 * width;
        }
    }
}

/// Between the needles a loop leaves one bed's side and comes to the other's.
void AbovePainter::placeFlight() {
    if (!m_scene.picture.flight) {
        return;
    }
    const machine::LoopFlight& flight = *m_scene.picture.flight;
    const SeenNeedle* from = m_scene.find(flight.from);
    const SeenNeedle* to = m_scene.find(flight.to);
    if (!from || !to) {
        return;
    }
    const double start = m_layout.stroke() * (1 - machine::kSeat) - m_layout.hook();
    const double hookOfTaker = tipOf(*to) - m_layout.hook();
    double stacked = 0;
    for (const machine::SeenLoop& loop : flight.loops) {
        LoopForm form;
        form.bed = flight.from.bed;
        form.pitches = blend(from->pitches, to->pitches, flight.progress);
        form.carrier = loop.carrier;
        form.halfWidth = std::min(0.34 * m_layout.pitch, 0.16 * m_layout.gap());
        form.crossing = blend(start, m_layout.gap() - hookOfTaker, flight.progress) + stacked;
        form.legs = form.crossing;
        form.flies = true;
        m_loops[loop.loop] = form;
        stacked += 1.15 * m_layout.yarnWidth();
    }
}

void AbovePainter::paint() {
    paintBeds();
    paintCarriage();
    paintRails();
    for (const SeenNeedle& needle : m_scene.picture.needles) {
        if (!machine::isSlider(needle.needle.bed)) {
            paintNeedle(needle);
        }
    }
    for (const SeenNeedle& needle : m_scene.picture.needles) {
        if (machine::isSlider(needle.needle.bed)) {
            paintSlider(needle);
        }
    }
    paintLinks();
    for (const auto& needle : m_scene.picture.needles) {
        for (const machine::SeenLoop& loop : needle.loops) {
            paintLoop(loop.loop, m_loops.at(loop.loop));
        }
        if (m_layout.pitch >= kLeastPitchWithHooks && !machine::isSlider(needle.needle.bed)) {
            paintHook(needle);
        }
    }
    if (m_scene.picture.flight) {
        for (const machine::SeenLoop& loop : m_scene.picture.flight->loops) {
            if (const auto found = m_loops.find(loop.loop); found != m_loops.end()) {
                paintLoop(loop.loop, found->second);
            }
        }
    }
    paintCounts();
    paintCarriers();
    paintNumbers(Bed::Rear);
    paintNumbers(Bed::Front);
}

void AbovePainter::paintBeds() {
    const QRectF& area = m_layout.area;
    for (const Bed bed : {Bed::Rear, Bed::Front}) {
        const double verge = m_layout.vergeY(bed);
        const double outer = verge + (machine::isFront(bed) ? 1 : -1) * m_layout.bedHeight();
        m_painter.fillRect(QRectF(area.left(), std::min(verge, outer), area.width(), m_layout.bedHeight()),
                           m_colours.bed);
        m_painter.setPen(QPen(m_colours.rail, 1.5));
        m_painter.drawLine(QPointF(area.left(), verge), QPointF(area.right(), verge));
    }
}

void AbovePainter::paintCarriage() {
    if (!m_scene.picture.carriage) {
        return;
    }
    const machine::SeenCarriage& carriage = *m_scene.picture.carriage;
    const double x = m_layout.xOf(carriage.pitches);
    const double top = m_layout.area.top() + 0.15 * m_layout.textHeight;
    const double half = std::max(1.1 * m_layout.pitch, 1.5 * m_layout.textHeight);
    QColor band = m_colours.accent;
    band.setAlphaF(0.13F);
    m_painter.fillRect(QRectF(x - half, top, 2 * half, m_layout.frontNumbersY() - top), band);
    const QRectF head(x - half, top, 2 * half, 1.1 * m_layout.textHeight);
    m_painter.setPen(Qt::NoPen);
    m_painter.setBrush(m_colours.accent);
    m_painter.drawRoundedRect(head, 4, 4);
    if (carriage.direction != 0) {
        const double reach = carriage.direction * 0.7 * m_layout.textHeight;
        const double wing = 0.3 * m_layout.textHeight;
        const QPointF tip(x + reach, head.center().y());
        m_painter.setPen(QPen(m_colours.onAccent, 2.2, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        m_painter.drawLine(QPointF(x - reach, tip.y()), tip);
        const double back = tip.x() - carriage.direction * wing;
        m_painter.drawLine(QPointF(back, tip.y() - wing), tip);
        m_painter.drawLine(QPointF(back, tip.y() + wing), tip);
    }
}

double AbovePainter::railY(int rail) const {
    const auto index = static_cast<double>(std::ranges::lower_bound(m_rails, rail) - m_rails.begin());
    const auto count = static_cast<double>(m_rails.size());
    const double apart = std::min(1.35 * m_layout.textHeight, 0.7 * m_layout.gap() / std::max(1.0, count));
    return m_layout.gapCentreY() + (0.5 * (count - 1) - index) * apart;
}

void AbovePainter::paintRails() {
    m_painter.setPen(QPen(m_colours.rail, 1));
    for (const int rail : m_rails) {
        m_painter.drawLine(QPointF(m_layout.area.left(), railY(rail)),
                           QPointF(m_layout.area.right(), railY(rail)));
    }
}

void AbovePainter::paintNeedle(const SeenNeedle& needle) {
    const bool works = m_scene.works(needle.needle);
    const double width = std::clamp(0.15 * m_layout.pitch, 1.0, 9.0);
    const QPointF tip = m_layout.at(needle.needle.bed, needle.pitches, tipOf(needle));
    const QPointF end = m_layout.at(needle.needle.bed, needle.pitches, -m_layout.bedHeight());
    m_painter.setPen(QPen(works ? m_colours.busyNeedle : m_colours.needle, works ? width + 1 : width,
                          Qt::SolidLine, Qt::RoundCap));
    m_painter.drawLine(end, tip);
}

/// A blade on both sides of its needle.
void AbovePainter::paintSlider(const SeenNeedle& slider) {
    if (m_layout.pitch < kLeastPitchWithLoops) {
        return;
    }
    const bool works = m_scene.works(slider.needle);
    const double half = 0.17 * m_layout.pitch;
    const QPointF tip = m_layout.at(slider.needle.bed, slider.pitches, tipOf(slider));
    const QPointF end = m_layout.at(slider.needle.bed, slider.pitches, -m_layout.bedHeight());
    QPainterPath blade(end - QPointF(half, 0));
    blade.lineTo(tip - QPointF(half, 0));
    blade.quadTo(tip + QPointF(0, tip.y() < end.y() ? -half : half), tip + QPointF(half, 0));
    blade.lineTo(end + QPointF(half, 0));
    m_painter.setBrush(Qt::NoBrush);
    m_painter.setPen(QPen(works ? m_colours.accent : m_colours.latch, works ? 2.2 : 1.2));
    m_painter.drawPath(blade);
}

/// The hook bends over the yarn that lies in it; the latch turns about its pivot.
void AbovePainter::paintHook(const SeenNeedle& needle) {
    const bool works = m_scene.works(needle.needle);
    const double width = std::clamp(0.15 * m_layout.pitch, 1.0, 9.0) + (works ? 1 : 0);
    const double tip = tipOf(needle);
    const auto at = [&](double u) { return m_layout.at(needle.needle.bed, needle.pitches, u); };
    const QColor metal = works ? m_colours.busyNeedle : m_colours.needle;
    m_painter.setPen(QPen(metal, width + 1.5, Qt::SolidLine, Qt::RoundCap));
    m_painter.drawLine(at(tip), at(tip - 0.45 * m_layout.hook()));
    if (!works) {
        return;
    }
    const double reach = 0.25 * m_layout.stroke();
    const double pivot = tip - m_layout.hook() - reach;
    m_painter.setPen(QPen(m_colours.accent, std::max(1.0, 0.5 * width), Qt::SolidLine, Qt::RoundCap));
    m_painter.drawLine(at(pivot), at(pivot + reach * blend(1, -1, needle.latch)));
}

void AbovePainter::paintLoop(machine::LoopIndex loop, const LoopForm& form) {
    const bool selected = loop == m_scene.selected;
    const QColor colour = m_scene.yarn(form.carrier);
    if (m_layout.pitch < kLeastPitchWithLoops) {
        const double size = std::max(2.0, 0.8 * m_layout.pitch);
        const QPointF centre = m_layout.at(form.bed, form.pitches, form.crossing);
        m_painter.fillRect(QRectF(centre.x() - 0.5 * size, centre.y() - 4, size, 8),
                           selected ? m_colours.accent : colour);
        return;
    }
    QColor halo;
    if (selected) {
        halo = m_colours.accent;
    }
    if (form.flies) {
        QPainterPath ring;
        ring.addEllipse(m_layout.at(form.bed, form.pitches, form.crossing), form.halfWidth,
                        std::max(1.6 * m_layout.hook(), 0.5 * form.halfWidth));
        paintYarn(m_painter, ring, colour, 1.2 * m_layout.yarnWidth(), halo);
        return;
    }
    const double side = form.halfWidth / m_layout.pitch;
    const double legs = blend(form.crossing, form.legs, 0.35 + 0.65 * form.drawn);
    const auto at = [&](double across, double u) {
        return m_layout.at(form.bed, form.pitches + across * side, u);
    };
    const double bend = form.crossing + (form.crossing - legs) * 0.35;
    QPainterPath path(at(-1, legs));
    path.cubicTo(at(-1.15, bend), at(-0.7, form.crossing), at(0, form.crossing));
    path.cubicTo(at(0.7, form.crossing), at(1.15, bend), at(1, legs));
    paintYarn(m_painter, path, colour, m_layout.yarnWidth(), halo);
}

/// Where the yarn leaves (or enters) a loop: the leg that its direction says.
QPointF AbovePainter::footOf(const machine::YarnEnd& end, bool leaving) const {
    const auto found = m_loops.find(end.loop);
    const double rest = 1.2 * m_layout.hook();
    if (found == m_loops.end()) {
        return m_layout.at(end.needle.bed, machine::positionPitches(end.needle, m_scene.picture.rack), rest);
    }
    const auto& made = m_scene.timeline.loops().loops[static_cast<std::size_t>(end.loop)];
    const LoopForm& form = found->second;
    const double side = machine::sign(made.direction) * (leaving ? 1 : -1) * form.halfWidth / m_layout.pitch;
    return m_layout.at(form.bed, form.pitches + side,
                       blend(form.crossing, form.legs, 0.35 + 0.65 * form.drawn));
}

/// Yarn that hangs between two places in the gap.
QPainterPath AbovePainter::strand(QPointF from, QPointF to) const {
    const double sag = 0.35 * std::min(std::abs(to.x() - from.x()), 0.3 * m_layout.gap());
    const auto towardsGap = [&](QPointF p) {
        return QPointF(p.x(), p.y() + (p.y() < m_layout.gapCentreY() ? sag : -sag));
    };
    QPainterPath path(from);
    path.cubicTo(towardsGap(from), towardsGap(to), to);
    return path;
}

void AbovePainter::paintLinks() {
    if (m_layout.pitch < kLeastPitchWithLoops) {
        return;
    }
    for (const machine::SeenLink& link : m_scene.picture.links) {
        paintYarn(m_painter, strand(footOf(link.from, true), footOf(link.to, false)),
                  m_scene.yarn(link.carrier), 0.75 * m_layout.yarnWidth());
    }
}

void AbovePainter::paintCarriers() {
    for (const machine::SeenCarrier& carrier : m_scene.picture.carriers) {
        if (carrier.yarn) {
            QPainterPath path(QPointF(m_layout.xOf(carrier.pitches), railY(carrier.rail)));
            path.lineTo(footOf(*carrier.yarn, true));
            paintYarn(m_painter, path, m_scene.yarn(carrier.carrier), 0.75 * m_layout.yarnWidth());
        }
    }
    for (const machine::SeenCarrier& carrier : m_scene.picture.carriers) {
        paintCarrier(carrier);
    }
}

void AbovePainter::paintCarrier(const machine::SeenCarrier& carrier) {
    const auto& carriers = m_scene.timeline.program().header.carriers;
    const QString name = QString::fromStdString(carriers[carrier.carrier].name);
    const double height = 1.15 * m_layout.textHeight;
    const double width = std::max(height, m_painter.fontMetrics().horizontalAdvance(name) + 0.5 * height);
    const QPointF centre(m_layout.xOf(carrier.pitches), railY(carrier.rail));
    const QRectF plate(centre.x() - 0.5 * width, centre.y() - 0.5 * height, width, height);
    const QColor colour = m_scene.yarn(carrier.carrier);
    m_painter.setPen(QPen(carrier.in ? m_colours.text : m_colours.faint, carrier.in ? 1.6 : 1,
                          carrier.in ? Qt::SolidLine : Qt::DotLine));
    m_painter.setBrush(carrier.in ? colour : m_colours.bed);
    m_painter.drawRoundedRect(plate, 0.3 * height, 0.3 * height);
    m_painter.setPen(carrier.in ? inkOn(colour) : m_colours.faint);
    m_painter.drawText(plate, Qt::AlignCenter, name);
    if (carrier.hooked) { // the inserting hook below it
        const QPointF top(centre.x(), plate.bottom() + 2);
        QPainterPath hook(top);
        hook.lineTo(top + QPointF(0, 0.35 * height));
        hook.cubicTo(top + QPointF(0, 0.75 * height), top + QPointF(-0.45 * height, 0.75 * height),
                     top + QPointF(-0.45 * height, 0.3 * height));
        m_painter.setBrush(Qt::NoBrush);
        m_painter.setPen(QPen(m_colours.text, 2, Qt::SolidLine, Qt::RoundCap));
        m_painter.drawPath(hook);
    }
}

/// How many loops lie on each other where one would not see it.
void AbovePainter::paintCounts() {
    if (m_layout.pitch < kLeastPitchWithLoops) {
        return;
    }
    m_painter.setPen(m_colours.text);
    for (const SeenNeedle& needle : m_scene.picture.needles) {
        const QString text = countText(needle);
        if (text.isEmpty()) {
            continue;
        }
        const QPointF centre = m_layout.at(needle.needle.bed, needle.pitches, -0.62 * m_layout.bedHeight());
        const QFontMetricsF metrics(m_painter.font());
        QRectF plate(0, 0, metrics.horizontalAdvance(text) + 6, metrics.height());
        plate.moveCenter(centre);
        m_painter.setBrush(m_colours.bed);
        m_painter.drawRoundedRect(plate, 3, 3);
        m_painter.drawText(plate, Qt::AlignCenter, text);
    }
}

void AbovePainter::paintNumbers(Bed bed) {
    const QFontMetricsF metrics(m_painter.font());
    const bool rear = bed == Bed::Rear;
    const double y = rear ? m_layout.rearNumbersY() : m_layout.frontNumbersY();
    const double height = 1.1 * m_layout.textHeight;
    const int step = numberStep(m_layout.pitch, metrics.horizontalAdvance(QStringLiteral("-888")) + 4);
    const auto box = [&](const SeenNeedle& needle, const QString& text) {
        const double width = metrics.horizontalAdvance(text) + 0.5 * height;
        return QRectF(m_layout.xOf(needle.pitches) - 0.5 * width, y, width, height);
    };
    std::vector<QRectF> taken;
    const auto paintNumber = [&](const SeenNeedle& needle, bool works) {
        const QString text = QString::number(needle.needle.index);
        const QRectF place = box(needle, text);
        const bool cut = place.left() < m_layout.area.left() || place.right() > m_layout.area.right();
        if ((cut && !works) ||
            std::ranges::any_of(taken, [&](const QRectF& t) { return t.intersects(place); })) {
            return;
        }
        if (works) {
            taken.push_back(place);
            m_painter.setPen(Qt::NoPen);
            m_painter.setBrush(m_colours.accent);
            m_painter.drawRoundedRect(place, 4, 4);
        }
        m_painter.setPen(works ? m_colours.onAccent : m_colours.faint);
        m_painter.drawText(place, Qt::AlignCenter, text);
    };
    for (const bool works : {true, false}) {
        for (const SeenNeedle& needle : m_scene.picture.needles) {
            if (needle.needle.bed == bed && m_scene.works(needle.needle) == works &&
                (works || needle.needle.index % step == 0)) {
                paintNumber(needle, works);
            }
        }
    }
}

} // namespace knittsim::ui
