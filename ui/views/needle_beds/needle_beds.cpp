#include "ui/views/needle_beds/needle_beds.h"

#include "ui/document/operation_text.h"
#include "ui/views/needle_beds/above_painter.h"
#include "ui/views/needle_beds/phase_text.h"
#include "ui/views/needle_beds/side_painter.h"

#include <QApplication>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>

namespace knittsim::ui {

using machine::Needle;

namespace {

constexpr int kTickMs = 16;
constexpr double kStepMs = 900;  ///< a step by hand takes at least so long
constexpr double kReadable = 12; ///< pixels a pitch that following keeps to
constexpr double kSmallest = 2;  ///< pixels a pitch
constexpr double kLargest = 90;
constexpr double kFitted = 46;
constexpr double kBeside = 5; ///< pitches beside the fabric, where carriers wait
constexpr double kZoomStep = 1.2;
constexpr double kAround = 1.6;            ///< pitches that are seen from the side
constexpr double kLeastWidthForBoth = 560; ///< side by side; else one above the other
constexpr double kLeastHeightForBoth = 380;

} // namespace

NeedleBeds::NeedleBeds(document::Document& document, QWidget* parent)
    : QWidget(parent), m_document(document) {
    setObjectName(QStringLiteral("needleBeds"));
    setAccessibleName(tr("Needle beds"));
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    m_timer.setInterval(kTickMs);
    connect(&m_timer, &QTimer::timeout, this, &NeedleBeds::tick);
    connect(&m_document, &document::Document::fileChanged, this, &NeedleBeds::takeFile);
    connect(&m_document, &document::Document::stepChanged, this, &NeedleBeds::takeStep);
    connect(&m_document, &document::Document::yarnsChanged, this, qOverload<>(&QWidget::update));
    connect(&m_document, &document::Document::selectionChanged, this, qOverload<>(&QWidget::update));
    takeFile();
}

void NeedleBeds::takeFile() {
    m_clock = {};
    m_clock.showStep(m_document.step(), 0);
    takeMotion();
    follow();
}

double NeedleBeds::durationMs() const {
    return m_playing ? 1000 / m_speed : std::max(kStepMs, 1000 / m_speed);
}

void NeedleBeds::takeStep() {
    m_clock.showStep(m_document.step(), isVisible() ? durationMs() : 0);
    if (m_clock.running() && !m_timer.isActive()) {
        m_sinceTick.start();
        m_timer.start();
    }
    takeMotion();
}

void NeedleBeds::setPlaying(bool on) {
    m_playing = on;
    // At the end of the program the player stops by itself; the last operation is still to be seen.
    m_clock.hold(!on && m_clock.moving() && m_document.step() < m_document.operationCount());
    if (m_clock.running()) {
        m_sinceTick.start();
        m_timer.start();
    }
}

void NeedleBeds::setSpeed(double operationsPerSecond) {
    m_speed = operationsPerSecond;
}

void NeedleBeds::tick() {
    m_clock.advance(static_cast<double>(m_sinceTick.nsecsElapsed()) * 1e-6);
    m_sinceTick.restart();
    if (!m_clock.running()) {
        m_timer.stop();
    }
    if (m_motion && m_motion->operation() != m_clock.operation()) {
        takeMotion();
    }
    update();
}

/// Makes what is shown from the file and the clock's operation.
void NeedleBeds::takeMotion() {
    m_motion.reset();
    m_file = m_document.file();
    if (m_file && isVisible()) {
        m_motion.emplace(*m_file->timeline, m_clock.operation());
        setAccessibleDescription(
            m_document.step() > 0 ? document::operationText(m_file->timeline->program(), m_clock.operation())
                                  : tr("Empty machine"));
        if (m_following) {
            keepInSight();
        }
    }
    update();
}

std::optional<double> NeedleBeds::workingPlace() const {
    if (!m_motion) {
        return std::nullopt;
    }
    const auto needle = machine::workingNeedle(m_file->timeline->program(), m_clock.operation());
    if (!needle) {
        return std::nullopt;
    }
    return machine::positionPitches(*needle, m_motion->at(m_clock.phase(), {0, -1}).rack);
}

/// Turns the page when the working needle comes near the rim, but not to where there is no fabric.
void NeedleBeds::keepInSight() {
    const auto place = workingPlace();
    const double half = 0.5 * m_layout.area.width() / m_layout.pitch;
    const double rim = std::min(3.0, 0.2 * half);
    if (!place || std::abs(*place - m_layout.centre) <= half - rim) {
        return;
    }
    const double first = m_file->grid->firstColumn();
    const double last = first + m_file->grid->columnCount() - 1;
    const double low = first - 1 + half;
    const double high = last + 1 - half;
    const double page = low < high ? std::clamp(*place, low, high) : 0.5 * (first + last);
    m_layout.centre = std::abs(*place - page) < half - 0.5 ? page : *place;
}

void NeedleBeds::follow() {
    m_following = true;
    m_zoomed = false;
    if (const auto file = m_document.file()) {
        const double columns = file->grid->columnCount() + 2 * kBeside;
        m_layout.centre = file->grid->firstColumn() + 0.5 * (file->grid->columnCount() - 1);
        m_layout.pitch = std::clamp(m_layout.area.width() / columns, kReadable, kFitted);
    }
    keepInSight();
    update();
}

void NeedleBeds::arrange() {
    const double base = QFontMetricsF(font()).height();
    const double large = std::clamp(std::min(height() / 16.0, width() / 50.0), base, 2.2 * base);
    m_face = font();
    m_face.setPointSizeF(font().pointSizeF() * large / base);
    const QRectF all = QRectF(rect()).adjusted(2, 2, -2, -2);
    const double gutter = 4.2 * large;
    QRectF above = all;
    m_side = {};
    if (width() >= kLeastWidthForBoth) {
        const double side = std::min(0.36 * all.width(), 1.2 * all.height());
        m_side = QRectF(all.right() - side, all.top(), side, all.height());
        above.setRight(m_side.left() - 6);
    } else if (height() >= kLeastHeightForBoth) {
        above.setHeight(0.52 * all.height());
        m_side = QRectF(all.left(), above.bottom() + 4, all.width(), all.bottom() - above.bottom() - 4);
    }
    m_layout.area = above.adjusted(gutter, 0, 0, 0);
    m_layout.textHeight = large;
}

machine::BedPicture NeedleBeds::picture() const {
    return m_motion ? m_motion->at(m_clock.phase(), m_layout.window()) : machine::BedPicture{};
}

QPoint NeedleBeds::placeOf(Needle needle) const {
    const double at = machine::positionPitches(needle, picture().rack);
    return m_layout.at(needle.bed, at, -m_layout.hook()).toPoint();
}

void NeedleBeds::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), palette().color(QPalette::Base));
    if (!m_motion) {
        return;
    }
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setFont(m_face);
    painter.setBackground(palette().color(QPalette::Base));
    std::vector<QColor> yarns;
    for (const document::CarrierYarn& carrier : m_document.carriers()) {
        const yarn::Colour& c = carrier.yarn.colour;
        yarns.emplace_back(c.r, c.g, c.b);
    }
    const machine::Program& program = m_file->timeline->program();
    std::vector<Needle> working;
    machine::Operation operation;
    if (m_document.step() > 0 || m_clock.moving()) {
        operation = program.operations[static_cast<std::size_t>(m_clock.operation())];
        if (machine::workingNeedle(program, m_clock.operation()) == operation.needle) {
            working.push_back(operation.needle);
        }
        if (operation.kind == machine::OperationKind::Xfer ||
            operation.kind == machine::OperationKind::Split) {
            working.push_back(operation.target);
        }
    }
    const auto scene = [&](const machine::BedPicture& seen) {
        return BedScene{seen, *m_file->timeline, yarns, palette(), working, m_document.selection().loop};
    };
    const machine::BedPicture above = picture();
    painter.save();
    painter.setClipRect(m_layout.area);
    AbovePainter(painter, m_layout, scene(above)).paint();
    painter.restore();
    paintNames(painter, above.rack);
    if (const auto place = workingPlace(); place && !m_side.isEmpty()) {
        const machine::BedWindow around{*place - kAround, *place + kAround};
        const machine::BedPicture near = m_motion->at(m_clock.phase(), around);
        const auto before = m_motion->at(0, around).needles;
        const auto worked = std::ranges::find(before, operation.needle, &machine::SeenNeedle::needle);
        const bool holdsLoop = worked != before.end() && !worked->loops.empty();
        SidePainter(painter, m_side, scene(near), *place)
            .paint(phaseText(operation, m_clock.phase(), holdsLoop));
    }
    if (hasFocus()) {
        painter.setRenderHint(QPainter::Antialiasing, false);
        painter.setPen(palette().color(QPalette::Highlight));
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(rect().adjusted(0, 0, -1, -1));
    }
}

/// The margin on the left: names of the beds and the racking.
void NeedleBeds::paintNames(QPainter& painter, double rack) {
    const double width = m_layout.area.left() - 4;
    const double high = m_layout.textHeight;
    const auto line = [&](double y, const QString& text) {
        painter.drawText(QRectF(2, y - 0.6 * high, width, 1.2 * high), Qt::AlignCenter, text);
    };
    const BedColours colours(palette());
    painter.setPen(colours.faint);
    line(m_layout.vergeY(machine::Bed::Rear) - 0.5 * m_layout.bedHeight(), tr("rear"));
    line(m_layout.vergeY(machine::Bed::Front) + 0.5 * m_layout.bedHeight(), tr("front"));
    line(m_layout.gapCentreY() - 0.8 * high, tr("rack"));
    QFont large = m_face;
    large.setBold(true);
    large.setPointSizeF(1.2 * m_face.pointSizeF());
    painter.setFont(large);
    painter.setPen(colours.text);
    line(m_layout.gapCentreY() + 0.5 * high, document::rackText(std::round(rack * 100) / 100));
    painter.setFont(m_face);
}

void NeedleBeds::resizeEvent(QResizeEvent*) {
    arrange();
    if (m_following && !m_zoomed) {
        follow();
    }
}

void NeedleBeds::showEvent(QShowEvent*) {
    m_clock.showStep(m_document.step(), 0);
    takeMotion();
}

void NeedleBeds::zoomAt(double x, double factor) {
    const double kept = m_layout.pitchesAt(x);
    m_layout.pitch = std::clamp(m_layout.pitch * factor, kSmallest, kLargest);
    m_layout.centre += kept - m_layout.pitchesAt(x);
    m_zoomed = true;
    update();
}

void NeedleBeds::mousePressEvent(QMouseEvent* event) {
    m_pressed = event->position().toPoint();
    m_centreAtPress = m_layout.centre;
    m_dragging = false;
}

void NeedleBeds::mouseMoveEvent(QMouseEvent* event) {
    if (!(event->buttons() & (Qt::LeftButton | Qt::MiddleButton))) {
        return;
    }
    const QPoint way = event->position().toPoint() - m_pressed;
    m_dragging = m_dragging || way.manhattanLength() >= QApplication::startDragDistance();
    if (m_dragging) {
        m_following = false;
        m_layout.centre = m_centreAtPress - way.x() / m_layout.pitch;
        update();
    }
}

void NeedleBeds::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton && !m_dragging && m_motion && m_layout.area.contains(m_pressed)) {
        const machine::BedPicture seen = picture();
        const Needle needle = m_layout.needleAt(m_pressed, seen.rack);
        const auto found = std::ranges::find(seen.needles, needle, &machine::SeenNeedle::needle);
        const bool holds = found != seen.needles.end() && !found->loops.empty();
        m_document.selectLoop(holds ? found->loops.back().loop : -1);
    }
    m_dragging = false;
}

void NeedleBeds::mouseDoubleClickEvent(QMouseEvent*) {
    follow();
}

void NeedleBeds::wheelEvent(QWheelEvent* event) {
    const double notches = (event->angleDelta().y() + event->angleDelta().x()) / 120.0;
    if (event->modifiers() & Qt::ControlModifier) {
        zoomAt(event->position().x(), std::pow(kZoomStep, notches));
    } else {
        m_following = false;
        m_layout.centre -= 2 * notches;
        update();
    }
    event->accept();
}

void NeedleBeds::keyPressEvent(QKeyEvent* event) {
    const double middle = m_layout.area.center().x();
    switch (event->key()) {
    case Qt::Key_Plus:
    case Qt::Key_Equal:
        zoomAt(middle, kZoomStep);
        break;
    case Qt::Key_Minus:
        zoomAt(middle, 1 / kZoomStep);
        break;
    default:
        QWidget::keyPressEvent(event);
    }
}

QString NeedleBeds::textAt(QPoint point) const {
    if (!m_motion || !m_layout.area.contains(point)) {
        return {};
    }
    const machine::BedPicture seen = picture();
    const Needle needle = m_layout.needleAt(point, seen.rack);
    const machine::Timeline& timeline = *m_file->timeline;
    QStringList lines;
    for (const machine::SeenNeedle& other : seen.needles) {
        if (other.needle.index != needle.index ||
            machine::isFront(other.needle.bed) != machine::isFront(needle.bed)) {
            continue;
        }
        QString name = document::needleText(other.needle);
        name[0] = name[0].toUpper();
        lines << (other.loops.empty()
                      ? tr("%1: no loop").arg(name)
                      : tr("%1: %n loop(s)", nullptr, static_cast<int>(other.loops.size())).arg(name));
        for (const machine::SeenLoop& loop : other.loops) {
            const auto& carriers = m_document.carriers();
            const QString yarn = loop.carrier < carriers.size()
                                     ? QString::fromStdString(carriers[loop.carrier].yarn.name)
                                     : QString();
            lines << tr("%1 (%2)").arg(
                document::stitchText(timeline.program(), timeline.loops(), *m_file->grid, loop.loop), yarn);
        }
    }
    return lines.join(u'\n');
}

bool NeedleBeds::event(QEvent* event) {
    if (event->type() == QEvent::ToolTip) {
        const auto* help = static_cast<QHelpEvent*>(event);
        const QString text = textAt(help->pos());
        text.isEmpty() ? QToolTip::hideText() : QToolTip::showText(help->globalPos(), text, this);
        return true;
    }
    if (event->type() == QEvent::FontChange) {
        arrange();
    }
    return QWidget::event(event);
}

} // namespace knittsim::ui
