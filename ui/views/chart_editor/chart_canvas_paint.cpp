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

constexpr int kLeastCellWithLines = 6;
constexpr int kLeastCellWithSymbol = 9;
constexpr int kLeastCellWithMoves = 4;
constexpr int kMostSymbols = 256;

bool isRear(Stitch stitch) {
    return stitch == Stitch::Purl;
}

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

/// One pixel a cell, scaled up in one go.
void ChartCanvas::paintGrounds(QPainter& painter) const {
    const Chart& chart = shown();
    const auto wales = m_geometry.visibleColumns();
    const auto courses = m_geometry.visibleCourses();
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
    const QRect first = m_geometry.cellRect(courses.end - 1, wales.first);
    const QRect last = m_geometry.cellRect(courses.first, wales.end - 1);
    painter.setRenderHint(QPainter::SmoothPixmapTransform, false);
    painter.drawImage(QRect(first.topLeft(), last.bottomRight()), image);
}

const QPixmap& ChartCanvas::symbol(Stitch stitch, const QSize& size, bool darkInk) {
    const quint64 key = static_cast<quint64>(size.width()) << 32U |
                        static_cast<quint64>(size.height()) << 16U | static_cast<quint64>(stitch) << 1U |
                        static_cast<quint64>(darkInk);
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
    paintStitch(painter, QRectF(QPointF(0, 0), QSizeF(size)), stitch, ink);
    painter.end();
    return *m_symbols.insert(key, pixmap);
}

void ChartCanvas::paintCells(QPainter& painter) {
    const Chart& chart = shown();
    const auto wales = m_geometry.visibleColumns();
    const auto courses = m_geometry.visibleCourses();
    if (m_geometry.cellWidth < kLeastCellWithMoves) {
        return;
    }
    const bool symbols = m_geometry.cellWidth >= kLeastCellWithSymbol;
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
                const QRect rect = m_geometry.cellRect(course, wale);
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
                painter, moves, [&](int wale) { return QRectF(m_geometry.cellRect(course, wale)); },
                inkOn(ground), ground);
        }
    }
}

void ChartCanvas::paintLines(QPainter& painter) const {
    if (m_geometry.cellWidth < kLeastCellWithLines) {
        return;
    }
    const auto wales = m_geometry.visibleColumns();
    const auto courses = m_geometry.visibleCourses();
    const QRect first = m_geometry.cellRect(courses.end - 1, wales.first);
    const QRect last = m_geometry.cellRect(courses.first, wales.end - 1);
    QVector<QLine> thin;
    QVector<QLine> strong;
    for (int wale = wales.first; wale <= wales.end; ++wale) {
        const int x = first.left() + (wale - wales.first) * m_geometry.cellWidth;
        (wale % 10 == 0 ? strong : thin) << QLine(x, first.top(), x, last.bottom());
    }
    for (int course = courses.first; course <= courses.end; ++course) {
        const int y = last.bottom() + 1 - (course - courses.first) * m_geometry.cellHeight();
        (course % 10 == 0 ? strong : thin) << QLine(first.left(), y, last.right(), y);
    }
    const int tone = isDark(palette()) ? 255 : 0;
    painter.setRenderHint(QPainter::Antialiasing, false);
    painter.setPen(QColor(tone, tone, tone, m_geometry.cellWidth < 12 ? 18 : 30));
    painter.drawLines(thin);
    painter.setPen(QColor(tone, tone, tone, m_geometry.cellWidth < 12 ? 60 : 90));
    painter.drawLines(strong);
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
    if (hasFocus()) {
        painter.setPen(QPen(palette().color(QPalette::Text), 1, Qt::DotLine));
        painter.drawRect(rectOf({m_cursor.wale, m_cursor.course, 1, 1}).adjusted(1, 1, -2, -2));
    }
}

void ChartCanvas::paintProblems(QPainter& painter) const {
    const Accents accents = accentsOf(palette());
    const QRect area = m_geometry.chartArea();
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

void ChartCanvas::paintHeaders(QPainter& painter) const {
    const QRect area = m_geometry.chartArea();
    const QColor ground = palette().color(QPalette::Window);
    const Accents accents = accentsOf(palette());
    painter.fillRect(0, 0, m_geometry.header.width(), m_geometry.view.height(), ground);
    painter.fillRect(0, area.bottom() + 1, m_geometry.view.width(), m_geometry.header.height(), ground);
    painter.setPen(accents.line);
    painter.drawLine(area.left() - 1, 0, area.left() - 1, area.bottom() + 1);
    painter.drawLine(area.left() - 1, area.bottom() + 1, m_geometry.view.width(), area.bottom() + 1);
    painter.setPen(accents.faintText);
    const QFontMetrics metrics(font());
    painter.save();
    painter.setClipRect(QRect(0, 0, m_geometry.header.width() - 1, area.height()));
    const auto courses = m_geometry.visibleCourses();
    const int rowStep = labelStep(m_geometry.cellHeight(), metrics.height() + 2);
    for (int course = courses.first; course < courses.end; ++course) {
        if ((course + 1) % rowStep == 0) {
            const QRect cell = m_geometry.cellRect(course, 0);
            painter.drawText(QRect(0, cell.center().y() - metrics.height() / 2, m_geometry.header.width() - 6,
                                   metrics.height()),
                             Qt::AlignRight | Qt::AlignVCenter, QString::number(course + 1));
        }
    }
    painter.setClipRect(QRect(area.left(), area.bottom() + 2, area.width(), m_geometry.header.height()));
    const auto wales = m_geometry.visibleColumns();
    const int digits = metrics.horizontalAdvance(QString::number(m_geometry.columns)) + 8;
    const int waleStep = labelStep(m_geometry.cellWidth, digits);
    for (int wale = wales.first; wale < wales.end; ++wale) {
        if ((wale + 1) % waleStep == 0) {
            QRect label(m_geometry.cellRect(0, wale).center().x() - digits / 2, area.bottom() + 3, digits,
                        m_geometry.header.height() - 3);
            label.moveRight(std::min(label.right(), area.right() + 4));
            painter.drawText(label, Qt::AlignCenter, QString::number(wale + 1));
        }
    }
    painter.restore();
}

void ChartCanvas::paintEvent(QPaintEvent*) {
    QPainter painter(viewport());
    painter.fillRect(viewport()->rect(), palette().color(QPalette::Base));
    if (!m_project) {
        return;
    }
    painter.save();
    painter.setClipRect(m_geometry.chartArea());
    paintGrounds(painter);
    paintLines(painter);
    paintCells(painter);
    paintProblems(painter);
    paintMarks(painter);
    painter.restore();
    paintHeaders(painter);
    if (hasFocus()) {
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(palette().color(QPalette::Highlight), 1));
        painter.drawRect(viewport()->rect().adjusted(0, 0, -1, -1));
    }
}

} // namespace knittsim::ui
