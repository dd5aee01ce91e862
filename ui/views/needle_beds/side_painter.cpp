#include "ui/views/needle_beds/side_painter.h"

#include "core/machine/needle_stroke.h"
#include "ui/document/operation_text.h"
#include "ui/views/style/appearance.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace knittsim::ui {

using machine::Bed;
using machine::LoopPlace;
using machine::SeenLoop;
using machine::SeenNeedle;

namespace {

constexpr double kSlope = 0.7071; ///< the beds stand at a right angle
constexpr double kOpenLatch = 168 * std::numbers::pi / 180;
constexpr double kClosedLatch = 16 * std::numbers::pi / 180;
constexpr double kSliderRest = 0.14;  ///< of the size, behind the hook
constexpr double kSliderRise = 0.045; ///< of the size, above the needle
constexpr double kNear = 1.3;         ///< pitches within which a carrier is seen in the section

} // namespace

SidePainter::SidePainter(QPainter& painter, const QRectF& area, const BedScene& scene, double pitches)
    : m_painter(painter), m_whole(area), m_scene(scene), m_colours(scene.palette), m_pitches(pitches) {
    const double line = QFontMetricsF(painter.font()).height();
    m_area = area.adjusted(0, 2.3 * line, 0, -1.3 * line);
    m_size = std::min(m_area.width(), 1.15 * m_area.height());
    m_stroke = 0.36 * m_size;
    m_hook = 0.05 * m_size;
    m_yarn = std::clamp(0.018 * m_size, 2.0, 12.0);
    const QPointF middle(m_area.center().x(), m_area.top() + 0.64 * m_area.height());
    const double gap = 0.055 * m_size;
    m_front = {middle + QPointF(-gap, 0), {kSlope, -kSlope}, {-kSlope, -kSlope}};
    m_rear = {middle + QPointF(gap, 0), {-kSlope, -kSlope}, {kSlope, -kSlope}};
    m_fabric = middle + QPointF(0, 0.1 * m_size);
}

const SeenNeedle* SidePainter::nearest(Bed bed) const {
    const SeenNeedle* best = nullptr;
    for (const SeenNeedle& needle : m_scene.picture.needles) {
        const double apart = std::abs(needle.pitches - m_pitches);
        if (needle.needle.bed == bed && apart <= 0.5 &&
            (!best || apart < std::abs(best->pitches - m_pitches))) {
            best = &needle;
        }
    }
    return best;
}

/// A slider at rest lies on its needle, behind the hook.
double SidePainter::tipOf(const SeenNeedle& needle) const {
    const double back = machine::isSlider(needle.needle.bed) ? kSliderRest * m_size : 0;
    return m_hook + m_stroke * needle.height - back * (1 - needle.height);
}

QPointF SidePainter::loopCentre(const Axis& axis, const SeenNeedle& needle, const SeenLoop& loop,
                                double stacked) const {
    if (loop.place == LoopPlace::KnockedOver) {
        return 0.45 * m_fabric + 0.55 * axis.at(0, 0);
    }
    const double rise = machine::isSlider(needle.needle.bed) ? kSliderRise : 0.006;
    return axis.at(tipOf(needle) - m_hook - m_stroke * loop.slide - stacked, rise * m_size);
}

void SidePainter::paint(const QString& caption) {
    const SeenNeedle* front = nearest(Bed::Front);
    const SeenNeedle* rear = nearest(Bed::Rear);
    if (m_area.height() < 1) {
        return;
    }
    m_painter.save();
    m_painter.setClipRect(m_area);
    paintBed(m_front);
    paintBed(m_rear);
    paintFabric();
    // The needle that works lies before the other one.
    const bool rearLast = rear && m_scene.works(rear->needle);
    for (const SeenNeedle* needle : {rearLast ? front : rear, rearLast ? rear : front}) {
        if (needle) {
            paintNeedle(axisOf(needle->needle.bed), *needle);
        }
    }
    const SeenNeedle* const sliders[] = {nearest(Bed::FrontSlider), nearest(Bed::RearSlider)};
    for (const SeenNeedle* slider : sliders) {
        if (slider) {
            paintSlider(axisOf(slider->needle.bed), *slider);
        }
    }
    paintFeeders();
    for (const SeenNeedle* needle : {sliders[0], sliders[1], front, rear}) {
        if (needle) {
            paintLoops(axisOf(needle->needle.bed), *needle);
        }
    }
    paintFlight();
    m_painter.restore();
    paintName(Bed::Front);
    paintName(Bed::Rear);
    paintCaption(caption);
}

void SidePainter::paintBed(const Axis& axis) {
    const double length = m_size;
    const double top = -0.035 * m_size;
    const double low = -0.13 * m_size;
    m_painter.setPen(QPen(m_colours.rail, 1.5));
    m_painter.setBrush(m_colours.bed);
    m_painter.drawPolygon(QPolygonF{axis.at(0, top), axis.at(-length, top), axis.at(-length, low),
                                    axis.at(-0.06 * m_size, low)});
}

void SidePainter::paintNeedle(const Axis& axis, const SeenNeedle& needle) {
    const bool works = m_scene.works(needle.needle);
    const QColor metal = works ? m_colours.busyNeedle : m_colours.needle;
    const double tip = tipOf(needle);
    const double width = std::max(2.0, 0.026 * m_size);
    m_painter.setBrush(Qt::NoBrush);
    m_painter.setPen(QPen(metal, width, Qt::SolidLine, Qt::FlatCap));
    m_painter.drawLine(axis.at(-m_size, -0.008 * m_size), axis.at(tip - 0.03 * m_size, -0.008 * m_size));
    // The butt, by which the carriage drives the needle.
    const double butt = m_stroke * needle.height - 0.42 * m_size;
    m_painter.setPen(QPen(metal, 1.6 * width, Qt::SolidLine, Qt::FlatCap));
    m_painter.drawLine(axis.at(butt, 0), axis.at(butt, 0.065 * m_size));
    const double reach = 0.045 * m_size; // how far the hook bends up
    QPainterPath hook(axis.at(tip - 0.04 * m_size, -0.008 * m_size));
    hook.cubicTo(axis.at(tip + 0.028 * m_size, -0.012 * m_size),
                 axis.at(tip + 0.034 * m_size, reach + 0.01 * m_size), axis.at(tip - 0.012 * m_size, reach));
    m_painter.setPen(QPen(metal, 0.75 * width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    m_painter.drawPath(hook);
    const double length = 0.25 * m_stroke + 0.035 * m_size;
    const double pivot = tip - m_hook - 0.25 * m_stroke;
    const double angle = kClosedLatch + (kOpenLatch - kClosedLatch) * needle.latch;
    m_painter.setPen(
        QPen(works ? m_colours.accent : m_colours.latch, 0.55 * width, Qt::SolidLine, Qt::RoundCap));
    m_painter.drawLine(axis.at(pivot, 0),
                       axis.at(pivot + length * std::cos(angle), length * std::sin(angle)));
}

/// A blade that lies on its needle and takes loops without a hook.
void SidePainter::paintSlider(const Axis& axis, const SeenNeedle& slider) {
    const double tip = tipOf(slider);
    const double height = kSliderRise * m_size;
    QPainterPath blade(axis.at(-m_size, height));
    blade.lineTo(axis.at(tip - 0.03 * m_size, height));
    blade.lineTo(axis.at(tip, 0.4 * height));
    m_painter.setBrush(Qt::NoBrush);
    m_painter.setPen(QPen(m_scene.works(slider.needle) ? m_colours.accent : m_colours.latch,
                          std::max(1.5, 0.018 * m_size), Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    m_painter.drawPath(blade);
}

/// A ring around the needle, its legs down to the fabric.
void SidePainter::paintLoop(QPointF centre, QPointF along, double half, const SeenLoop& loop) {
    const QPointF across(-along.y(), along.x());
    const double slim = 0.4 * half;
    QTransform turn(along.x(), along.y(), across.x(), across.y(), centre.x(), centre.y());
    QPainterPath ring;
    ring.addEllipse(QPointF(0, 0), slim, half);
    ring = turn.map(ring);
    const QPointF low = centre + across * (across.y() > 0 ? half : -half);
    QPainterPath leg(low);
    leg.quadTo(QPointF(0.5 * (low.x() + m_fabric.x()), 0.5 * (low.y() + m_fabric.y()) + 0.02 * m_size),
               m_fabric);
    leg.addPath(ring);
    QColor halo;
    if (loop.loop == m_scene.selected) {
        halo = m_colours.accent;
    }
    paintYarn(m_painter, leg, m_scene.yarn(loop.carrier), m_yarn, halo);
}

void SidePainter::paintLoops(const Axis& axis, const SeenNeedle& needle) {
    double stacked = 1.3 * m_yarn * (static_cast<double>(needle.loops.size()) - 1);
    for (const SeenLoop& loop : needle.loops) {
        const bool outside = loop.place == LoopPlace::OverLatch || loop.place == LoopPlace::Shaft;
        const double half = (outside ? 0.056 : 0.036) * m_size;
        paintLoop(loopCentre(axis, needle, loop, stacked), axis.along, half * (0.6 + 0.4 * loop.drawn), loop);
        stacked -= 1.3 * m_yarn;
    }
}

void SidePainter::paintFlight() {
    if (!m_scene.picture.flight) {
        return;
    }
    const machine::LoopFlight& flight = *m_scene.picture.flight;
    const SeenNeedle* from = m_scene.find(flight.from);
    const SeenNeedle* to = m_scene.find(flight.to);
    if (!from || !to) {
        return;
    }
    const Axis& giver = axisOf(from->needle.bed);
    const Axis& taker = axisOf(to->needle.bed);
    const QPointF begin = giver.at(m_stroke * (1 - machine::kSeat), 0);
    const QPointF end = taker.at(tipOf(*to) - m_hook, 0);
    const QPointF centre = begin + (end - begin) * flight.progress;
    const QPointF along = giver.along + (taker.along - giver.along) * flight.progress;
    const double length = std::hypot(along.x(), along.y());
    for (const SeenLoop& loop : flight.loops) {
        paintLoop(centre, along / length, 0.056 * m_size, loop);
    }
}

/// A strip of stitches below the verges, pulled down by the take-down.
void SidePainter::paintFabric() {
    const SeenLoop* any = nullptr;
    const auto find = [&](const std::vector<SeenLoop>& loops) {
        for (const SeenLoop& loop : loops) {
            // A loop that was just hung up has nothing below it.
            if (loop.place == LoopPlace::KnockedOver ||
                !m_scene.timeline.loops().parentsOf(loop.loop).empty()) {
                any = &loop;
            }
        }
    };
    for (const SeenNeedle& needle : m_scene.picture.needles) {
        find(needle.loops);
    }
    if (m_scene.picture.flight) {
        find(m_scene.picture.flight->loops);
    }
    if (!any) {
        return;
    }
    QPainterPath chain;
    const double step = 0.055 * m_size;
    for (double y = m_fabric.y(); y < m_area.bottom() + step; y += step) {
        chain.addEllipse(QPointF(m_fabric.x(), y + 0.6 * step), 0.3 * step, 0.62 * step);
    }
    paintYarn(m_painter, chain, m_scene.yarn(any->carrier), 0.8 * m_yarn);
}

/// Carriers near the section, with the yarn down to the loop they made last.
void SidePainter::paintFeeders() {
    const QFontMetricsF metrics(m_painter.font());
    QPointF top(m_area.center().x(), m_area.top() + 1.4 * metrics.height());
    const auto& names = m_scene.timeline.program().header.carriers;
    for (const machine::SeenCarrier& carrier : m_scene.picture.carriers) {
        const double apart = carrier.pitches - m_pitches;
        if (!carrier.in || std::abs(apart) > kNear) {
            continue;
        }
        QPointF end = m_fabric;
        for (const SeenNeedle& needle : m_scene.picture.needles) {
            for (const SeenLoop& loop : needle.loops) {
                if (carrier.yarn && loop.loop == carrier.yarn->loop) {
                    end = loopCentre(axisOf(needle.needle.bed), needle, loop, 0);
                }
            }
        }
        const QColor colour = m_scene.yarn(carrier.carrier);
        QPainterPath yarn(top);
        yarn.lineTo(end);
        paintYarn(m_painter, yarn, colour, m_yarn);
        const QString name = QString::fromStdString(names[carrier.carrier].name);
        const double height = 1.25 * metrics.height();
        const double width = std::max(height, metrics.horizontalAdvance(name) + 0.5 * height);
        const QRectF plate(top.x() - 0.5 * width, top.y() - height, width, height);
        m_painter.setPen(QPen(m_colours.text, 1.6));
        m_painter.setBrush(colour);
        m_painter.drawRoundedRect(plate, 0.3 * height, 0.3 * height);
        m_painter.setPen(inkOn(colour));
        m_painter.drawText(plate, Qt::AlignCenter, name);
        top += QPointF(1.15 * width, 0);
    }
}

/// The slider's name where it works.
void SidePainter::paintName(Bed bed) {
    const bool front = machine::isFront(bed);
    const SeenNeedle* needle = nearest(bed);
    const SeenNeedle* slider = nearest(front ? Bed::FrontSlider : Bed::RearSlider);
    if (slider && m_scene.works(slider->needle)) {
        needle = slider;
    }
    const QString count = needle ? countText(*needle) : QString();
    const QString text = needle  ? (document::needleText(needle->needle) + u' ' + count).trimmed()
                         : front ? QCoreApplication::translate("beds", "front bed")
                                 : QCoreApplication::translate("beds", "rear bed");
    const bool works = needle && m_scene.works(needle->needle);
    const double height = QFontMetricsF(m_painter.font()).height();
    const QRectF line(m_whole.left() + 4, m_whole.bottom() - 1.2 * height, m_whole.width() - 8, height);
    m_painter.setPen(works ? m_colours.text : m_colours.faint);
    m_painter.drawText(line, front ? Qt::AlignLeft : Qt::AlignRight, text);
}

void SidePainter::paintCaption(const QString& caption) {
    const double height = QFontMetricsF(m_painter.font()).height();
    m_painter.setPen(m_colours.text);
    m_painter.drawText(m_whole.adjusted(4, 2, -4, 2.3 * height - m_whole.height()),
                       static_cast<int>(Qt::AlignHCenter | Qt::AlignTop) | Qt::TextWordWrap, caption);
}

} // namespace knittsim::ui
