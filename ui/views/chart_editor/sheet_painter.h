#pragma once

#include "ui/views/chart_editor/chart_sheet.h"

#include <QFont>

class QPainter;

namespace knittsim::ui {

/// Paints the parts of a chart sheet. Lengths are those of the painter: points or pixels.
class SheetPainter {
public:
    static constexpr double kTitleHeight = 34;

    SheetPainter(QPainter& painter, const ChartSheet& sheet);

    /// Of the chart with its numbers.
    QSizeF sizeOf(pattern::CellRange range, double cell) const;
    /// The largest cell with which the range fits.
    double fittingCell(QSizeF room, pattern::CellRange range) const;
    /// Wales and courses that fit; at least one.
    QSize cellsIn(QSizeF room, double cell) const;
    double legendHeight(double width) const;

    void paintTitle(const QRectF& page, const QString& part);
    /// In the upper middle of `room`. False where `progress`, told after each course, ended it.
    bool paintChart(const QRectF& room, pattern::CellRange range, double cell,
                    const SheetProgress& progress = {});
    void paintLegend(const QRectF& rect);

    QString partText(pattern::CellRange range, int page, int pages) const;

private:
    double rowHeight(double cell) const;
    QColor colourOf(const pattern::Cell& cell) const;
    QString nameOf(const SheetYarn& yarn) const;
    std::vector<LegendEntry> entries() const;
    void paintCourse(pattern::CellRange range, int course, QPointF corner, double cell);
    void paintNumbers(pattern::CellRange range, QPointF corner, double cell);
    void paintGrid(pattern::CellRange range, QPointF corner, double cell);

    QPainter& m_painter;
    const ChartSheet& m_sheet;
    QFont m_font;
    double m_side = 0; ///< room for numbers at the left and right
};

} // namespace knittsim::ui
