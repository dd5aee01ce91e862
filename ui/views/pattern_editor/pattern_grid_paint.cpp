#include "ui/views/pattern_editor/pattern_grid.h"
#include "ui/views/style/appearance.h"

#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cstdlib>

namespace knittsim::ui {

using document::GridCell;
using machine::LoopIndex;

namespace {

constexpr int kLeastCellWithLines = 7;
constexpr int kLeastCellWithSymbol = 9;

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

void PatternGrid::paintGrounds(QPainter& painter) const {
    const auto columns = m_chart.visibleColumns();
    const auto courses = m_chart.visibleCourses();
    if (columns.first >= columns.end || courses.first >= courses.end) {
        return;
    }
    // One pixel a column and two a course, scaled up in one go.
    QImage image(columns.end - columns.first, 2 * (courses.end - courses.first),
                 QImage::Format_ARGB32_Premultiplied);
    image.fill(Qt::transparent);
    const QColor base = palette().color(QPalette::Base);
    const std::int32_t origin = grid()->firstColumn() + columns.first;
    for (std::int32_t course = courses.first; course < courses.end; ++course) {
        const int y = 2 * (courses.end - 1 - course);
        auto* upper = reinterpret_cast<QRgb*>(image.scanLine(y));
        auto* lower = reinterpret_cast<QRgb*>(image.scanLine(y + 1));
        const auto row = grid()->row(course);
        auto cell =
            std::lower_bound(row.begin(), row.end(), origin,
                             [](const GridCell& c, std::int32_t column) { return c.column < column; });
        for (; cell != row.end() && cell->column - origin < image.width(); ++cell) {
            const auto shade = [&](LoopIndex loop, bool rear) {
                return CellPainter::ground(colourOf(loop), rear, isFaint(loop), base).rgb();
            };
            const LoopIndex top = cell->rear >= 0 ? cell->rear : cell->front;
            const LoopIndex bottom = cell->front >= 0 ? cell->front : cell->rear;
            upper[cell->column - origin] = shade(top, cell->rear >= 0);
            lower[cell->column - origin] = shade(bottom, cell->front < 0);
        }
    }
    const QRect first = m_chart.cellRect(courses.end - 1, columns.first);
    const QRect last = m_chart.cellRect(courses.first, columns.end - 1);
    painter.setRenderHint(QPainter::SmoothPixmapTransform, false);
    painter.drawImage(QRect(first.topLeft(), last.bottomRight()), image);
}

void PatternGrid::paintLines(QPainter& painter) const {
    if (m_chart.cellWidth < kLeastCellWithLines) {
        return;
    }
    const auto columns = m_chart.visibleColumns();
    const auto courses = m_chart.visibleCourses();
    const QRect first = m_chart.cellRect(courses.end - 1, columns.first);
    const QRect last = m_chart.cellRect(courses.first, columns.end - 1);
    QVector<QLine> thin;
    QVector<QLine> strong;
    for (int column = columns.first; column <= columns.end; ++column) {
        const int x = first.left() + (column - columns.first) * m_chart.cellWidth;
        ((column + grid()->firstColumn()) % 10 == 0 ? strong : thin)
            << QLine(x, first.top(), x, last.bottom());
    }
    for (int course = courses.first; course <= courses.end; ++course) {
        const int y = last.bottom() + 1 - (course - courses.first) * m_chart.cellHeight();
        (course % 10 == 0 ? strong : thin) << QLine(first.left(), y, last.right(), y);
    }
    const bool dark = isDark(palette());
    painter.setRenderHint(QPainter::Antialiasing, false);
    painter.setPen(QColor(dark ? 255 : 0, dark ? 255 : 0, dark ? 255 : 0, m_chart.cellWidth < 12 ? 14 : 26));
    painter.drawLines(thin);
    painter.setPen(QColor(dark ? 255 : 0, dark ? 255 : 0, dark ? 255 : 0, m_chart.cellWidth < 12 ? 46 : 70));
    painter.drawLines(strong);
}

void PatternGrid::paintFloats(QPainter& painter, std::int32_t course) const {
    const auto columns = m_chart.visibleColumns();
    const std::int32_t origin = grid()->firstColumn();
    for (const document::GridFloat& strand : grid()->floats(course)) {
        const QColor yarn = strand.carrier < m_colours.size() ? m_colours[strand.carrier] : QColor(Qt::gray);
        QColor line =
            CellPainter::ground(yarn, false, isFaint(strand.before), palette().color(QPalette::Base));
        const int thickness = std::max(2, m_chart.cellWidth / 6);
        const std::int32_t from = std::max(strand.first, columns.first + origin);
        const std::int32_t to = std::min(strand.last, columns.end - 1 + origin);
        for (std::int32_t column = from; column <= to; ++column) {
            if (!grid()->cellAt(course, column)) {
                const QRect cell = m_chart.cellRect(course, column - origin);
                const QRect bar(cell.left(), cell.center().y() - thickness / 2, cell.width(), thickness);
                painter.fillRect(bar.adjusted(0, -1, 0, 1), QColor(0, 0, 0, 60));
                painter.fillRect(bar, line);
            }
        }
    }
}

void PatternGrid::paintSymbols(QPainter& painter) {
    const auto columns = m_chart.visibleColumns();
    const auto courses = m_chart.visibleCourses();
    const QColor base = palette().color(QPalette::Base);
    const std::int32_t origin = grid()->firstColumn();
    for (std::int32_t course = courses.first; course < courses.end; ++course) {
        paintFloats(painter, course);
        if (m_chart.cellWidth < kLeastCellWithSymbol) {
            continue;
        }
        for (const GridCell& cell : grid()->row(course)) {
            if (cell.column < origin + columns.first || cell.column >= origin + columns.end) {
                continue;
            }
            for (const LoopIndex loop : {cell.front, cell.rear}) {
                if (loop >= 0) {
                    const document::StitchMark mark = grid()->markOf(loop);
                    const bool faint = isFaint(loop);
                    m_cells.drawSymbol(painter, rectOf(loop), mark,
                                       CellPainter::ground(colourOf(loop), mark.rear, faint, base), faint);
                }
            }
        }
    }
}

void PatternGrid::paintMarker(QPainter& painter, LoopIndex loop, const QColor& colour, int width) const {
    const QRectF rect = QRectF(rectOf(loop)).adjusted(-0.5, -0.5, 0.5, 0.5);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(palette().color(QPalette::Base), width + 2));
    painter.drawRoundedRect(rect, 2, 2);
    painter.setPen(QPen(colour, width));
    painter.drawRoundedRect(rect, 2, 2);
}

void PatternGrid::paintProblems(QPainter& painter) const {
    const Accents accents = accentsOf(palette());
    const QRect area = m_chart.chartArea();
    for (const auto& [loop, problem] : m_document.problemMarks()) {
        const QRectF cell = rectOf(loop);
        if (!area.intersects(cell.toRect())) {
            continue;
        }
        paintProblemCorner(painter, cell,
                           problem.severity == Severity::Error ? accents.error : accents.warning,
                           palette().color(QPalette::Base));
    }
}

void PatternGrid::paintHeaders(QPainter& painter) const {
    const QRect area = m_chart.chartArea();
    const QColor ground = palette().color(QPalette::Window);
    const Accents accents = accentsOf(palette());
    painter.fillRect(0, 0, m_chart.header.width(), m_chart.view.height(), ground);
    painter.fillRect(0, area.bottom() + 1, m_chart.view.width(), m_chart.header.height(), ground);
    painter.setPen(accents.line);
    painter.drawLine(area.left() - 1, 0, area.left() - 1, area.bottom() + 1);
    painter.drawLine(area.left() - 1, area.bottom() + 1, m_chart.view.width(), area.bottom() + 1);

    const document::GridPlace selected = m_document.selection().loop >= 0
                                             ? grid()->placeOf(m_document.selection().loop)
                                             : document::GridPlace{};
    const QFontMetrics metrics(font());
    const auto label = [&](const QRect& rect, int number, bool strong, int align) {
        QFont face = font();
        face.setBold(strong);
        painter.setFont(face);
        painter.setPen(strong ? palette().color(QPalette::WindowText) : accents.faintText);
        painter.drawText(rect, align, QString::number(number));
    };
    painter.save();
    painter.setClipRect(QRect(0, 0, m_chart.header.width() - 1, area.height()));
    const auto courses = m_chart.visibleCourses();
    const auto near = [&](std::int32_t course, std::int32_t other) {
        return other >= 0 && std::abs(course - other) * m_chart.cellHeight() < metrics.height();
    };
    const int rowStep = labelStep(m_chart.cellHeight(), metrics.height() + 2);
    for (std::int32_t course = courses.first; course < courses.end; ++course) {
        const bool strong = course == selected.course || course == m_currentCourse;
        const bool covered = !strong && (near(course, selected.course) || near(course, m_currentCourse));
        if (strong || (!covered && (course + 1) % rowStep == 0)) {
            const QRect cell = m_chart.cellRect(course, 0);
            const QRect rect(0, cell.center().y() - metrics.height() / 2, m_chart.header.width() - 6,
                             metrics.height());
            painter.fillRect(rect, ground);
            label(rect, course + 1, strong, Qt::AlignRight | Qt::AlignVCenter);
        }
    }
    painter.setClipRect(QRect(area.left(), area.bottom() + 2, area.width(), m_chart.header.height()));
    const auto columns = m_chart.visibleColumns();
    const std::int32_t origin = grid()->firstColumn();
    const int digits = metrics.horizontalAdvance(QString::number(origin + m_chart.columns)) + 8;
    const int columnStep = labelStep(m_chart.cellWidth, digits);
    for (std::int32_t column = columns.first; column < columns.end; ++column) {
        const bool strong = selected.course >= 0 && column + origin == selected.column;
        const bool covered = !strong && selected.course >= 0 &&
                             std::abs(column + origin - selected.column) * m_chart.cellWidth < digits;
        if (strong || (!covered && (column + origin) % columnStep == 0)) {
            const QRect cell = m_chart.cellRect(0, column);
            const QRect rect(cell.center().x() - digits / 2, area.bottom() + 3, digits,
                             m_chart.header.height() - 3);
            painter.fillRect(rect, ground);
            label(rect, column + origin, strong, Qt::AlignHCenter | Qt::AlignVCenter);
        }
    }
    painter.restore();
}

void PatternGrid::paintEvent(QPaintEvent*) {
    QPainter painter(viewport());
    painter.fillRect(viewport()->rect(), palette().color(QPalette::Base));
    const document::StitchGrid* chart = grid();
    if (!chart || chart->loopCount() == 0) {
        painter.setPen(accentsOf(palette()).faintText);
        painter.drawText(viewport()->rect().adjusted(12, 12, -12, -12), Qt::AlignCenter | Qt::TextWordWrap,
                         chart ? tr("This program makes no stitches.") : tr("Nothing is open."));
        return;
    }
    painter.save();
    painter.setClipRect(m_chart.chartArea());
    paintGrounds(painter);
    paintLines(painter);
    paintSymbols(painter);
    paintProblems(painter);
    if (m_hover >= 0) {
        paintMarker(painter, m_hover, palette().color(QPalette::Highlight).lighter(120), 1);
    }
    if (m_document.selection().loop >= 0) {
        paintMarker(painter, m_document.selection().loop, palette().color(QPalette::Highlight), 2);
    }
    painter.restore();
    paintHeaders(painter);
    if (hasFocus()) {
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(palette().color(QPalette::Highlight), 1));
        painter.drawRect(viewport()->rect().adjusted(0, 0, -1, -1));
    }
}

} // namespace knittsim::ui
