// The part of a chart that stands beside the cells: columns with what a course is made of.

#include "ui/views/pattern_editor/chart_area.h"
#include "ui/views/style/appearance.h"

#include <QPainter>
#include <QPainterPath>

#include <algorithm>

namespace knittsim::ui {

namespace {

constexpr int kMostYarns = 4; ///< that are shown of a course
constexpr int kLeastArrow = 7;

QString titleOf(SideColumn column) {
    switch (column) {
    case SideColumn::Carrier:
        return ChartArea::tr("Yarn");
    case SideColumn::StitchSize:
        return ChartArea::tr("Size");
    case SideColumn::Racking:
        return ChartArea::tr("Rack");
    default:
        return {};
    }
}

void paintArrow(QPainter& painter, const QRectF& rect, int direction) {
    const double half = std::min(4.0, rect.height() / 2 - 1);
    const QPointF middle = rect.center();
    const QPointF tip = middle + QPointF(direction * 4.5, 0);
    QPainterPath path(middle - QPointF(direction * 4.5, 0));
    path.lineTo(tip);
    path.moveTo(tip + QPointF(-direction * half, -half));
    path.lineTo(tip);
    path.lineTo(tip + QPointF(-direction * half, half));
    painter.setRenderHint(QPainter::Antialiasing);
    painter.drawPath(path);
    painter.setRenderHint(QPainter::Antialiasing, false);
}

} // namespace

bool ChartArea::isShown(SideColumn column) const {
    switch (m_look.shown(column)) {
    case ChartLook::Shown::Always:
        return true;
    case ChartLook::Shown::Never:
        return false;
    case ChartLook::Shown::ByContent:
        break;
    }
    return tells(m_notes, column) || (column == SideColumn::Carrier && m_severalYarns);
}

int ChartArea::widthOf(SideColumn column) const {
    const QFontMetrics metrics(font());
    std::size_t yarns = 1;
    for (const CourseNote& note : m_notes) {
        yarns = std::max(yarns, std::min<std::size_t>(note.yarns.size(), kMostYarns));
    }
    const int title = metrics.horizontalAdvance(titleOf(column)) + 8;
    const int count = static_cast<int>(yarns);
    switch (column) {
    case SideColumn::Course: {
        const int digits = std::max(3, static_cast<int>(QString::number(m_geometry.courses).size()));
        return metrics.horizontalAdvance(QString(digits, u'8')) + 13;
    }
    case SideColumn::Direction:
        return count * 13 + 5;
    case SideColumn::Carrier:
        return std::max(title, count * carrierWidth() + 6);
    case SideColumn::StitchSize:
        return std::max(title, metrics.horizontalAdvance(QStringLiteral("88.8")) + 8);
    case SideColumn::Racking:
        return std::max(title, metrics.horizontalAdvance(QStringLiteral("\u22128.25")) + 8);
    case SideColumn::Needle:
        break;
    }
    return 0;
}

int ChartArea::carrierWidth() const {
    const QFontMetrics metrics(font());
    int width = 14;
    for (const CourseNote& note : m_notes) {
        for (const CourseNote::Yarn& yarn : note.yarns) {
            width = std::max(width, std::min(40, metrics.horizontalAdvance(yarn.carrier) + 7));
        }
    }
    return width;
}

void ChartArea::layoutSides() {
    m_sides.clear();
    int left = 0;
    for (const SideColumn column : {SideColumn::Course, SideColumn::Direction, SideColumn::Carrier,
                                    SideColumn::StitchSize, SideColumn::Racking}) {
        if (isShown(column)) {
            const int width = widthOf(column);
            m_sides.push_back({column, left, width});
            left += width;
        }
    }
    const bool strip = isShown(SideColumn::Needle) || left > 0;
    m_geometry.header = {left, strip ? QFontMetrics(font()).height() + 6 : 0};
}

std::optional<ChartArea::SidePlace> ChartArea::sideAt(QPoint position) const {
    const int row = position.y() - m_geometry.origin().y();
    if (position.x() >= m_geometry.header.width() || row < 0 || row >= m_geometry.content().height() ||
        position.y() > m_geometry.chartArea().bottom()) {
        return std::nullopt;
    }
    for (const Side& side : m_sides) {
        if (position.x() >= side.left && position.x() < side.left + side.width) {
            return SidePlace{side.column, m_geometry.courses - 1 - row / m_geometry.cellHeight()};
        }
    }
    return std::nullopt;
}

QString ChartArea::sideText(QPoint position) const {
    const auto place = sideAt(position);
    if (place && static_cast<std::size_t>(place->course) < m_notes.size()) {
        return noteText(m_notes[static_cast<std::size_t>(place->course)], place->course);
    }
    for (const Side& side : m_sides) {
        if (position.y() > m_geometry.chartArea().bottom() && position.x() >= side.left &&
            position.x() < side.left + side.width) {
            return ChartLook::nameOf(side.column);
        }
    }
    return {};
}

QRect ChartArea::sideRect(SidePlace place) const {
    const auto side = std::ranges::find(m_sides, place.column, &Side::column);
    const QRect cell = m_geometry.cellRect(place.course, 0);
    return side == m_sides.end() ? QRect() : QRect(side->left, cell.top(), side->width - 1, cell.height());
}

void ChartArea::paintYarns(QPainter& painter, const QRect& rect, const CourseNote& note) const {
    const int width = carrierWidth();
    const bool named = rect.height() >= QFontMetrics(font()).height() - 3;
    for (std::size_t i = 0; i < std::min<std::size_t>(note.yarns.size(), kMostYarns); ++i) {
        const CourseNote::Yarn& yarn = note.yarns[i];
        const QRect box(rect.left() + 3 + static_cast<int>(i) * width, rect.top(), width - 1,
                        std::max(1, rect.height() - (rect.height() > 3 ? 1 : 0)));
        painter.fillRect(box, yarn.colour);
        if (named) {
            painter.setPen(inkOn(yarn.colour));
            painter.drawText(box, Qt::AlignCenter, yarn.carrier);
        }
    }
}

void ChartArea::paintSide(QPainter& painter, const Side& side, int course, bool labelled) const {
    const CourseNote& note = m_notes[static_cast<std::size_t>(course)];
    const QRect cell = sideRect({side.column, course});
    const int height = QFontMetrics(font()).height();
    const QRect label(cell.left(), cell.center().y() - height / 2, cell.width() - 4, height);
    const Accents accents = accentsOf(palette());
    if (side.column == SideColumn::Carrier) {
        paintYarns(painter, cell, note);
    } else if (side.column == SideColumn::Direction && (labelled || cell.height() >= kLeastArrow)) {
        painter.setPen(QPen(palette().color(QPalette::WindowText), 1.2));
        const auto arrows = static_cast<int>(std::min<std::size_t>(note.yarns.size(), kMostYarns));
        for (int i = 0; i < arrows; ++i) {
            if (const int direction = note.yarns[static_cast<std::size_t>(i)].direction; direction != 0) {
                const int room = cell.height() >= kLeastArrow ? cell.height() : height;
                paintArrow(painter,
                           QRectF(cell.left() + 3 + i * 13, cell.center().y() - room / 2.0, 11, room),
                           direction);
            }
        }
    } else if (side.column == SideColumn::StitchSize && note.stitchSize && labelled) {
        painter.setPen(note.ownStitchSize ? palette().color(QPalette::WindowText) : accents.faintText);
        painter.drawText(label, Qt::AlignRight | Qt::AlignVCenter, QString::number(*note.stitchSize, 'g', 4));
    } else if (side.column == SideColumn::Racking && labelled) {
        painter.setPen(note.racking != 0 ? palette().color(QPalette::WindowText) : accents.faintText);
        painter.drawText(label, Qt::AlignRight | Qt::AlignVCenter, QString::number(note.racking, 'g', 4));
    }
}

void ChartArea::paintSides(QPainter& painter, int labelEvery) const {
    const auto courses = m_geometry.visibleCourses();
    const QRect area = m_geometry.chartArea();
    painter.setFont(font());
    for (const Side& side : m_sides) {
        if (side.column == SideColumn::Course) {
            continue;
        }
        painter.setClipRect(QRect(side.left, 0, side.width, area.height()));
        for (int course = courses.first;
             course < std::min(courses.end, static_cast<std::int32_t>(m_notes.size())); ++course) {
            paintSide(painter, side, course, (course + 1) % labelEvery == 0);
        }
        painter.setClipRect(QRect(side.left, area.bottom() + 2, side.width, m_geometry.header.height()));
        painter.setPen(accentsOf(palette()).faintText);
        painter.drawText(QRect(side.left, area.bottom() + 3, side.width - 4, m_geometry.header.height() - 3),
                         Qt::AlignCenter, titleOf(side.column));
    }
}

} // namespace knittsim::ui
