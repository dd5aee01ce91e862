#include "ui/views/pattern_editor/chart_area.h"
#include "ui/views/style/appearance.h"

#include <QPainter>

#include <algorithm>
#include <cstdlib>

namespace knittsim::ui {

namespace {

/// Numbers stand so far apart that they do not touch.
int labelStep(int pixelsPerItem, int labelPixels) {
    for (const int step : {1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000}) {
        if (step * pixelsPerItem >= labelPixels) {
            return step;
        }
    }
    return 10000;
}

} // namespace

void ChartArea::paintLines(QPainter& painter) const {
    if (m_geometry.cellWidth < m_cells.leastWithLines) {
        return;
    }
    const auto columns = m_geometry.visibleColumns();
    const auto courses = m_geometry.visibleCourses();
    const QRect first = m_geometry.cellRect(courses.end - 1, columns.first);
    const QRect last = m_geometry.cellRect(courses.first, columns.end - 1);
    QVector<QLine> thin;
    QVector<QLine> strong;
    for (int column = columns.first; column <= columns.end; ++column) {
        const int x = first.left() + (column - columns.first) * m_geometry.cellWidth;
        // Tens are counted as the numbers below count them, from 1.
        ((column + m_firstNumber - 1) % 10 == 0 ? strong : thin) << QLine(x, first.top(), x, last.bottom());
    }
    for (int course = courses.first; course <= courses.end; ++course) {
        const int y = last.bottom() + 1 - (course - courses.first) * m_geometry.cellHeight();
        (course % 10 == 0 ? strong : thin) << QLine(first.left(), y, last.right(), y);
    }
    // Seen on light and on dark yarns.
    constexpr int kTone = 128;
    const bool small = m_geometry.cellWidth < 12;
    painter.setRenderHint(QPainter::Antialiasing, false);
    painter.setPen(QColor(kTone, kTone, kTone, small ? 45 : 75));
    painter.drawLines(thin);
    painter.setPen(QColor(kTone, kTone, kTone, small ? 120 : 180));
    painter.drawLines(strong);
}

void ChartArea::paintNumber(QPainter& painter, const QRect& rect, int number, bool strong, int align) const {
    QFont face = font();
    face.setBold(strong);
    painter.setFont(face);
    painter.fillRect(rect, palette().color(QPalette::Window));
    painter.setPen(strong ? palette().color(QPalette::WindowText) : accentsOf(palette()).faintText);
    painter.drawText(rect, align, QString::number(number));
}

void ChartArea::paintRowNumbers(QPainter& painter, const std::vector<int>& strongCourses) const {
    if (m_sides.empty() || m_sides.front().column != SideColumn::Course) {
        return;
    }
    const int width = m_sides.front().width;
    const int height = QFontMetrics(font()).height();
    const int cellHeight = m_geometry.cellHeight();
    const auto courses = m_geometry.visibleCourses();
    const int step = labelStep(cellHeight, height + 2);
    painter.setClipRect(QRect(0, 0, width - 1, m_geometry.chartArea().height()));
    for (int course = courses.first; course < courses.end; ++course) {
        const bool strong = std::ranges::find(strongCourses, course) != strongCourses.end();
        const bool covered = !strong && std::ranges::any_of(strongCourses, [&](int other) {
            return std::abs(course - other) * cellHeight < height;
        });
        if (strong || (!covered && (course + 1) % step == 0)) {
            const int middle = m_geometry.cellRect(course, 0).center().y();
            paintNumber(painter, {0, middle - height / 2, width - 6, height}, course + 1, strong,
                        Qt::AlignRight | Qt::AlignVCenter);
        }
    }
}

void ChartArea::paintColumnNumbers(QPainter& painter, std::optional<int> strongColumn) const {
    const QRect area = m_geometry.chartArea();
    const auto columns = m_geometry.visibleColumns();
    const int digits =
        QFontMetrics(font()).horizontalAdvance(QString::number(m_firstNumber + m_geometry.columns)) + 8;
    const int step = labelStep(m_geometry.cellWidth, digits);
    painter.setClipRect(QRect(area.left(), area.bottom() + 2, area.width(), m_geometry.header.height()));
    for (int column = columns.first; column < columns.end; ++column) {
        const bool strong = column == strongColumn;
        const bool covered =
            !strong && strongColumn && std::abs(column - *strongColumn) * m_geometry.cellWidth < digits;
        if (strong || (!covered && (column + m_firstNumber) % step == 0)) {
            QRect label(m_geometry.cellRect(0, column).center().x() - digits / 2, area.bottom() + 3, digits,
                        m_geometry.header.height() - 3);
            label.moveRight(std::min(label.right(), area.right() + 4));
            paintNumber(painter, label, column + m_firstNumber, strong, Qt::AlignCenter);
        }
    }
}

void ChartArea::paintHeaders(QPainter& painter, const std::vector<int>& strongCourses,
                             std::optional<int> strongColumn) const {
    const QRect area = m_geometry.chartArea();
    const QColor ground = palette().color(QPalette::Window);
    painter.fillRect(0, 0, m_geometry.header.width(), m_geometry.view.height(), ground);
    painter.fillRect(0, area.bottom() + 1, m_geometry.view.width(), m_geometry.header.height(), ground);
    painter.setPen(accentsOf(palette()).line);
    painter.drawLine(area.left() - 1, 0, area.left() - 1, area.bottom() + 1);
    painter.drawLine(area.left() - 1, area.bottom() + 1, m_geometry.view.width(), area.bottom() + 1);
    painter.save();
    paintRowNumbers(painter, strongCourses);
    paintSides(painter, labelStep(m_geometry.cellHeight(), QFontMetrics(font()).height() + 2));
    if (isShown(SideColumn::Needle)) {
        paintColumnNumbers(painter, strongColumn);
    }
    painter.restore();
}

void ChartArea::paintFocus(QPainter& painter) const {
    if (hasFocus()) {
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(palette().color(QPalette::Highlight), 1));
        painter.drawRect(viewport()->rect().adjusted(0, 0, -1, -1));
    }
}

} // namespace knittsim::ui
