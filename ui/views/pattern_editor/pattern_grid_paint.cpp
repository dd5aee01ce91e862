#include "ui/views/pattern_editor/pattern_grid.h"
#include "ui/views/style/appearance.h"

#include <QPainter>
#include <QPainterPath>

#include <algorithm>

namespace knittsim::ui {

using document::GridCell;
using machine::LoopIndex;

namespace {

constexpr int kLeastCellWithSymbol = 9;

} // namespace

void PatternGrid::paintGrounds(QPainter& painter) const {
    const auto columns = geometryOfChart().visibleColumns();
    const auto courses = geometryOfChart().visibleCourses();
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
    const QRect first = geometryOfChart().cellRect(courses.end - 1, columns.first);
    const QRect last = geometryOfChart().cellRect(courses.first, columns.end - 1);
    painter.setRenderHint(QPainter::SmoothPixmapTransform, false);
    painter.drawImage(QRect(first.topLeft(), last.bottomRight()), image);
}

void PatternGrid::paintFloats(QPainter& painter, std::int32_t course) const {
    const auto columns = geometryOfChart().visibleColumns();
    const std::int32_t origin = grid()->firstColumn();
    for (const document::GridFloat& strand : grid()->floats(course)) {
        const QColor yarn = strand.carrier < m_colours.size() ? m_colours[strand.carrier] : QColor(Qt::gray);
        QColor line =
            CellPainter::ground(yarn, false, isFaint(strand.before), palette().color(QPalette::Base));
        const int thickness = std::max(2, geometryOfChart().cellWidth / 6);
        const std::int32_t from = std::max(strand.first, columns.first + origin);
        const std::int32_t to = std::min(strand.last, columns.end - 1 + origin);
        for (std::int32_t column = from; column <= to; ++column) {
            if (!grid()->cellAt(course, column)) {
                const QRect cell = geometryOfChart().cellRect(course, column - origin);
                const QRect bar(cell.left(), cell.center().y() - thickness / 2, cell.width(), thickness);
                painter.fillRect(bar.adjusted(0, -1, 0, 1), QColor(0, 0, 0, 60));
                painter.fillRect(bar, line);
            }
        }
    }
}

void PatternGrid::paintSymbols(QPainter& painter) {
    const auto columns = geometryOfChart().visibleColumns();
    const auto courses = geometryOfChart().visibleCourses();
    const QColor base = palette().color(QPalette::Base);
    const std::int32_t origin = grid()->firstColumn();
    for (std::int32_t course = courses.first; course < courses.end; ++course) {
        paintFloats(painter, course);
        if (geometryOfChart().cellWidth < kLeastCellWithSymbol) {
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
                    m_cells.drawSymbol(painter, rectOf(loop), mark, look().symbols(),
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
    const QRect area = geometryOfChart().chartArea();
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
    painter.setClipRect(geometryOfChart().chartArea());
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
    std::vector<int> courses{m_currentCourse};
    std::optional<int> column;
    if (m_document.selection().loop >= 0) {
        const document::GridPlace place = grid()->placeOf(m_document.selection().loop);
        courses.push_back(place.course);
        column = place.column - grid()->firstColumn();
    }
    paintHeaders(painter, courses, column);
    paintFocus(painter);
}

} // namespace knittsim::ui
