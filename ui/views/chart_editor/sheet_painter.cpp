#include "ui/views/chart_editor/sheet_painter.h"

#include "ui/views/chart_editor/chart_legend.h"
#include "ui/views/chart_editor/stitch_picture.h"
#include "ui/views/pattern_editor/cell_painter.h"
#include "ui/views/style/appearance.h"
#include "ui/views/style/numbers.h"

#include <QCoreApplication>
#include <QPainter>

#include <algorithm>

namespace knittsim::ui {

using pattern::Cell;
using pattern::CellRange;
using pattern::Stitch;

namespace {

constexpr double kNumber = 12; ///< height of the needle numbers
constexpr double kEntry = 22;  ///< height of a line of the legend
constexpr double kEntryWidth = 250;
constexpr double kLeastWithSymbol = 4; ///< smaller ones would be a smear

QString tr(const char* text) {
    return QCoreApplication::translate("knittsim::ui::SheetPainter", text);
}

/// Numbers stand so far apart that they do not touch.
int stepOf(double cell, double label) {
    for (const int step : {1, 2, 5, 10, 20, 50, 100, 200, 500}) {
        if (step * cell >= label) {
            return step;
        }
    }
    return 1000;
}

} // namespace

SheetPainter::SheetPainter(QPainter& painter, const ChartSheet& sheet)
    : m_painter(painter), m_sheet(sheet), m_font(QStringLiteral("sans-serif")) {
    m_font.setPixelSize(8);
    const auto digits = QString::number(std::max(sheet.chart.height(), 10)).size();
    m_side = 5.0 * static_cast<double>(digits) + 5;
}

double SheetPainter::rowHeight(double cell) const {
    return cell * (m_sheet.chart.beds == pattern::BedUse::Double ? 1.2 : 0.82);
}

QSizeF SheetPainter::sizeOf(CellRange range, double cell) const {
    return {range.width * cell + 2 * m_side, range.height * rowHeight(cell) + 2 * kNumber};
}

double SheetPainter::fittingCell(QSizeF room, CellRange range) const {
    return std::min((room.width() - 2 * m_side) / range.width,
                    (room.height() - 2 * kNumber) / (range.height * rowHeight(1)));
}

QSize SheetPainter::cellsIn(QSizeF room, double cell) const {
    return {std::max(1, static_cast<int>((room.width() - 2 * m_side) / cell)),
            std::max(1, static_cast<int>((room.height() - 2 * kNumber) / rowHeight(cell)))};
}

QColor SheetPainter::colourOf(const Cell& cell) const {
    return cell.yarn < m_sheet.yarns.size() ? m_sheet.yarns[cell.yarn].colour : QColor(Qt::lightGray);
}

QString SheetPainter::nameOf(const SheetYarn& yarn) const {
    const QString name = tr("Carrier %1: %2").arg(yarn.carrier, yarn.name);
    return yarn.metres > 0 ? tr("%1, %2 m, %3 g").arg(name, shortNumber(yarn.metres), shortNumber(yarn.grams))
                           : name;
}

std::vector<LegendEntry> SheetPainter::entries() const {
    std::vector<LegendEntry> all = legendOf(m_sheet.chart, m_sheet.symbols);
    for (const SheetYarn& yarn : m_sheet.yarns) {
        all.push_back(yarnEntry(nameOf(yarn), yarn.colour));
    }
    return all;
}

double SheetPainter::legendHeight(double width) const {
    const int columns = std::max(1, static_cast<int>(width / kEntryWidth));
    const int lines = (static_cast<int>(entries().size()) + columns - 1) / columns;
    return lines * kEntry;
}

void SheetPainter::paintLegend(const QRectF& rect) {
    const int columns = std::max(1, static_cast<int>(rect.width() / kEntryWidth));
    const double width = rect.width() / columns;
    int index = 0;
    for (const LegendEntry& entry : entries()) {
        const QRectF line(rect.left() + index % columns * width, rect.top() + index / columns * kEntry, width,
                          kEntry);
        const QRectF picture(line.left() + 0.5, line.top() + 2, 28, kEntry - 5);
        m_painter.save();
        entry.paint(m_painter, picture.adjusted(3, 1, -3, -1), Qt::black);
        m_painter.restore();
        m_painter.setBrush(Qt::NoBrush);
        m_painter.setPen(QPen(QColor(120, 120, 120), 0.5));
        m_painter.drawRect(picture);
        m_painter.setPen(Qt::black);
        m_painter.setFont(m_font);
        m_painter.drawText(line.adjusted(34, 0, -6, -1), Qt::AlignLeft | Qt::AlignVCenter | Qt::TextWordWrap,
                           entry.name);
        ++index;
    }
}

QString SheetPainter::partText(CellRange range, int page, int pages) const {
    return tr("Needles %1 to %2, courses %3 to %4 \u2013 page %5 of %6")
        .arg(range.wale + m_sheet.firstNeedle)
        .arg(range.wale + m_sheet.firstNeedle + range.width - 1)
        .arg(range.course + 1)
        .arg(range.course + range.height)
        .arg(page)
        .arg(pages);
}

void SheetPainter::paintTitle(const QRectF& page, const QString& part) {
    QFont face = m_font;
    face.setPixelSize(13);
    face.setBold(true);
    m_painter.setFont(face);
    m_painter.setPen(Qt::black);
    m_painter.drawText(QRectF(page.left(), page.top(), page.width(), 17), Qt::AlignLeft, m_sheet.title);
    m_painter.setFont(m_font);
    m_painter.drawText(QRectF(page.left(), page.top() + 17, page.width(), 12), Qt::AlignLeft,
                       part.isEmpty()
                           ? tr("%1 wales x %2 courses").arg(m_sheet.chart.width).arg(m_sheet.chart.height())
                           : part);
}

void SheetPainter::paintCourse(CellRange range, int course, QPointF corner, double cell) {
    const pattern::Chart& chart = m_sheet.chart;
    const double height = rowHeight(cell);
    const double top = corner.y() + (range.course + range.height - 1 - course) * height;
    const auto cellOf = [&](int wale) {
        return QRectF(corner.x() + (wale - range.wale) * cell, top, cell, height);
    };
    const auto groundOf = [&](const Cell& at) {
        return pattern::isWorked(at.stitch)
                   ? CellPainter::ground(colourOf(at), at.stitch == Stitch::Purl, false, Qt::white)
                   : QColor(Qt::white);
    };
    // Neighbours of one colour are one box.
    for (int wale = range.wale; wale < range.wale + range.width;) {
        const QColor ground = groundOf(chart.at(wale, course));
        int end = wale + 1;
        while (end < range.wale + range.width && groundOf(chart.at(end, course)) == ground) {
            ++end;
        }
        m_painter.fillRect(QRectF(cellOf(wale).topLeft(), cellOf(end - 1).bottomRight()), ground);
        wale = end;
    }
    if (cell < kLeastWithSymbol) {
        return;
    }
    const auto& moves = chart.course(course).moves;
    for (int wale = range.wale; wale < range.wale + range.width; ++wale) {
        const Cell& at = chart.at(wale, course);
        const bool moved = std::ranges::any_of(
            moves, [&](const pattern::LoopMove& move) { return move.from == wale || move.to == wale; });
        if (!moved || !pattern::isWorked(at.stitch)) {
            paintStitch(m_painter, cellOf(wale), at.stitch, m_sheet.symbols, inkOn(groundOf(at)));
        }
    }
    if (!moves.empty()) {
        const QColor ground = colourOf(chart.at(std::clamp(moves[0].to, 0, chart.width - 1), course));
        m_painter.save();
        m_painter.setClipRect(QRectF(corner.x(), top, range.width * cell, height));
        paintMoves(m_painter, moves, cellOf, m_sheet.symbols, inkOn(ground), ground);
        m_painter.restore();
    }
}

void SheetPainter::paintGrid(CellRange range, QPointF corner, double cell) {
    const double height = rowHeight(cell);
    const QSizeF size(range.width * cell, range.height * height);
    m_painter.setRenderHint(QPainter::Antialiasing, false);
    const auto pen = [&](int index) {
        m_painter.setPen(index % 10 == 0 ? QPen(QColor(60, 60, 60), 0.8) : QPen(QColor(140, 140, 140), 0.3));
        return index % 10 == 0 || cell >= kLeastWithSymbol;
    };
    for (int wale = 0; wale <= range.width; ++wale) {
        if (pen(range.wale + wale)) {
            const double x = corner.x() + wale * cell;
            m_painter.drawLine(QPointF(x, corner.y()), QPointF(x, corner.y() + size.height()));
        }
    }
    for (int course = 0; course <= range.height; ++course) {
        if (pen(range.course + course)) {
            const double y = corner.y() + size.height() - course * height;
            m_painter.drawLine(QPointF(corner.x(), y), QPointF(corner.x() + size.width(), y));
        }
    }
    m_painter.setBrush(Qt::NoBrush);
    m_painter.setPen(QPen(Qt::black, 0.8));
    m_painter.drawRect(QRectF(corner, size));
}

void SheetPainter::paintNumbers(CellRange range, QPointF corner, double cell) {
    const double height = rowHeight(cell);
    m_painter.setFont(m_font);
    m_painter.setPen(Qt::black);
    const int courseStep = stepOf(height, 9);
    for (int course = range.course; course < range.course + range.height; ++course) {
        if ((course + 1) % courseStep == 0) {
            const double middle = corner.y() + (range.course + range.height - course - 0.5) * height;
            const QString number = QString::number(course + 1);
            m_painter.drawText(QRectF(corner.x() - m_side, middle - 5, m_side - 3, 10),
                               Qt::AlignRight | Qt::AlignVCenter, number);
            m_painter.drawText(QRectF(corner.x() + range.width * cell + 3, middle - 5, m_side, 10),
                               Qt::AlignLeft | Qt::AlignVCenter, number);
        }
    }
    const int waleStep = stepOf(cell, m_side);
    for (int wale = range.wale; wale < range.wale + range.width; ++wale) {
        const int needle = wale + m_sheet.firstNeedle;
        if (needle % waleStep == 0) {
            const double left = corner.x() + (wale - range.wale + 0.5) * cell - m_side;
            for (const double top : {corner.y() - kNumber + 1, corner.y() + range.height * height + 1}) {
                m_painter.drawText(QRectF(left, top, 2 * m_side, kNumber - 2), Qt::AlignCenter,
                                   QString::number(needle));
            }
        }
    }
}

bool SheetPainter::paintChart(const QRectF& room, CellRange range, double cell,
                              const SheetProgress& progress) {
    const QPointF corner(room.left() + (room.width() - range.width * cell) / 2, room.top() + kNumber);
    for (int course = range.course; course < range.course + range.height; ++course) {
        paintCourse(range, course, corner, cell);
        if (progress && !progress(course - range.course + 1, range.height)) {
            return false;
        }
    }
    paintGrid(range, corner, cell);
    paintNumbers(range, corner, cell);
    return true;
}

} // namespace knittsim::ui
