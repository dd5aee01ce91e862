#include "ui/views/chart_editor/chart_canvas.h"
#include "ui/views/chart_editor/stitch_picture.h"
#include "ui/views/style/appearance.h"

#include <QPainter>

#include <algorithm>

namespace knittsim::ui {

using pattern::Cell;
using pattern::Chart;
using pattern::Stitch;

namespace {

constexpr int kLeastCellWithSymbol = 8;
constexpr int kLeastCellWithMoves = 4;
constexpr int kMostSymbols = 256;

bool isRear(Stitch stitch) {
    return stitch == Stitch::Purl;
}

} // namespace

/// One pixel a cell, scaled up in one go.
void ChartCanvas::paintGrounds(QPainter& painter) const {
    const Chart& chart = shown();
    const auto wales = geometryOfChart().visibleColumns();
    const auto courses = geometryOfChart().visibleCourses();
    if (wales.first >= wales.end || courses.first >= courses.end) {
        return;
    }
    QImage image(wales.end - wales.first, courses.end - courses.first, QImage::Format_RGB32);
    const QColor base = palette().color(QPalette::Base);
    const int knitted =
        m_document.step() < m_document.operationCount() ? m_document.knittedCourses() : chart.height();
    for (int course = courses.first; course < courses.end; ++course) {
        auto* row = reinterpret_cast<QRgb*>(image.scanLine(courses.end - 1 - course));
        for (int wale = wales.first; wale < wales.end; ++wale) {
            const Cell& cell = chart.at(wale, course);
            row[wale - wales.first] =
                pattern::isWorked(cell.stitch)
                    ? CellPainter::ground(colourOf(cell), isRear(cell.stitch), course >= knitted, base).rgb()
                    : base.rgb();
        }
    }
    const QRect first = geometryOfChart().cellRect(courses.end - 1, wales.first);
    const QRect last = geometryOfChart().cellRect(courses.first, wales.end - 1);
    painter.setRenderHint(QPainter::SmoothPixmapTransform, false);
    painter.drawImage(QRect(first.topLeft(), last.bottomRight()), image);
}

const QPixmap& ChartCanvas::symbol(Stitch stitch, const QSize& size, bool darkInk) {
    const quint64 key = static_cast<quint64>(size.width()) << 32U |
                        static_cast<quint64>(size.height()) << 16U | static_cast<quint64>(stitch) << 4U |
                        static_cast<quint64>(look().symbols()) << 1U | static_cast<quint64>(darkInk);
    const auto found = m_symbols.constFind(key);
    if (found != m_symbols.constEnd()) {
        return *found;
    }
    if (m_symbols.size() > kMostSymbols) {
        m_symbols.clear();
    }
    QPixmap pixmap(size * devicePixelRatioF());
    pixmap.setDevicePixelRatio(devicePixelRatioF());
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    QColor ink = darkInk ? Qt::black : Qt::white;
    ink.setAlphaF(darkInk ? 0.72F : 0.86F);
    paintStitch(painter, QRectF(QPointF(0, 0), QSizeF(size)), stitch, look().symbols(), ink);
    painter.end();
    return *m_symbols.insert(key, pixmap);
}

void ChartCanvas::paintCells(QPainter& painter) {
    const Chart& chart = shown();
    const auto wales = geometryOfChart().visibleColumns();
    const auto courses = geometryOfChart().visibleCourses();
    if (geometryOfChart().cellWidth < kLeastCellWithMoves) {
        return;
    }
    const bool symbols = geometryOfChart().cellWidth >= kLeastCellWithSymbol;
    std::vector<char> moved(static_cast<std::size_t>(chart.width));
    for (int course = courses.first; course < courses.end; ++course) {
        const auto& moves = chart.course(course).moves;
        std::ranges::fill(moved, char{0});
        for (const pattern::LoopMove& move : moves) {
            moved[static_cast<std::size_t>(move.from)] = moved[static_cast<std::size_t>(move.to)] = 1;
        }
        for (int wale = wales.first; symbols && wale < wales.end; ++wale) {
            const Cell& cell = chart.at(wale, course);
            const bool plain = moved[static_cast<std::size_t>(wale)] != 0 && pattern::isWorked(cell.stitch);
            if (!plain) {
                const QRect rect = geometryOfChart().cellRect(course, wale);
                const QColor ground =
                    pattern::isWorked(cell.stitch)
                        ? CellPainter::ground(colourOf(cell), isRear(cell.stitch), false, Qt::white)
                        : palette().color(QPalette::Base);
                painter.drawPixmap(rect.topLeft(),
                                   symbol(cell.stitch, rect.size(), inkOn(ground).lightness() < 128));
            }
        }
        if (!moves.empty()) {
            const QColor ground = colourOf(chart.at(std::clamp(moves[0].to, 0, chart.width - 1), course));
            paintMoves(
                painter, moves, [&](int wale) { return QRectF(geometryOfChart().cellRect(course, wale)); },
                look().symbols(), inkOn(ground), ground);
        }
    }
}

void ChartCanvas::paintMarks(QPainter& painter) const {
    painter.setRenderHint(QPainter::Antialiasing, false);
    painter.setBrush(Qt::NoBrush);
    const QColor highlight = palette().color(QPalette::Highlight);
    if (!m_selection.empty()) {
        const QRect rect = rectOf(m_selection);
        QColor veil = highlight;
        veil.setAlpha(38);
        painter.fillRect(rect, veil);
        painter.setPen(QPen(palette().color(QPalette::Base), 3));
        painter.drawRect(rect.adjusted(0, 0, -1, -1));
        painter.setPen(QPen(highlight, 1.6));
        painter.drawRect(rect.adjusted(0, 0, -1, -1));
        painter.fillRect(handle(), palette().color(QPalette::Base));
        painter.fillRect(handle().adjusted(1, 1, -1, -1), highlight);
    }
    if (const auto cell = m_document.cellOfLoop(m_document.selection().loop)) {
        painter.setPen(QPen(palette().color(QPalette::Base), 4));
        painter.drawRect(rectOf({cell->wale, cell->course, 1, 1}).adjusted(0, 0, -1, -1));
        painter.setPen(QPen(highlight, 2));
        painter.drawRect(rectOf({cell->wale, cell->course, 1, 1}).adjusted(0, 0, -1, -1));
    }
    const bool stamps = m_tool == ChartTool::Stamp && m_module && m_hovered && !m_stroke;
    if (const pattern::CellRange stamp = stamps ? stampRange(*m_hovered) : pattern::CellRange{};
        !stamp.empty()) {
        const QRect rect = rectOf(stamp).adjusted(0, 0, -1, -1);
        painter.setPen(QPen(palette().color(QPalette::Base), 3));
        painter.drawRect(rect);
        painter.setPen(QPen(highlight, 2, Qt::DashLine));
        painter.drawRect(rect);
    }
    if (hasFocus()) {
        painter.setPen(QPen(palette().color(QPalette::Text), 1, Qt::DotLine));
        painter.drawRect(rectOf({m_cursor.wale, m_cursor.course, 1, 1}).adjusted(1, 1, -2, -2));
    }
}

void ChartCanvas::paintProblems(QPainter& painter) const {
    const Accents accents = accentsOf(palette());
    const QRect area = geometryOfChart().chartArea();
    for (const auto& [loop, problem] : m_document.problemMarks()) {
        const auto place = m_document.cellOfLoop(loop);
        const QRectF cell = place ? QRectF(rectOf({place->wale, place->course, 1, 1})) : QRectF();
        if (!area.intersects(cell.toRect())) {
            continue;
        }
        paintProblemCorner(painter, cell,
                           problem.severity == Severity::Error ? accents.error : accents.warning,
                           palette().color(QPalette::Base));
    }
}

void ChartCanvas::paintEvent(QPaintEvent*) {
    QPainter painter(viewport());
    painter.fillRect(viewport()->rect(), palette().color(QPalette::Base));
    if (!m_project) {
        return;
    }
    painter.save();
    painter.setClipRect(geometryOfChart().chartArea());
    paintGrounds(painter);
    paintLines(painter);
    paintCells(painter);
    paintProblems(painter);
    paintMarks(painter);
    painter.restore();
    paintHeaders(painter);
    paintFocus(painter);
}

} // namespace knittsim::ui
