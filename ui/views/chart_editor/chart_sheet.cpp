#include "ui/views/chart_editor/chart_sheet.h"

#include "core/base/file.h"
#include "ui/views/chart_editor/chart_legend.h"
#include "ui/views/chart_editor/sheet_painter.h"

#include <QBuffer>
#include <QPainter>
#include <QPdfWriter>

#include <algorithm>
#include <filesystem>

namespace knittsim::ui {

using pattern::CellRange;

namespace {

constexpr double kPointsPerMm = 72.0 / 25.4;
constexpr double kLeastCell = 3.4 * kPointsPerMm; ///< to be read without a glass
constexpr double kLargestCell = 7.0 * kPointsPerMm;
constexpr int kMarginMm = 12;

Diagnostics write(const QString& path, const QByteArray& bytes) {
    return writeFileAtomically(std::filesystem::path(path.toStdString()),
                               {bytes.constData(), static_cast<std::size_t>(bytes.size())})
        .diagnostics();
}

Diagnostics ended() {
    return {{"KS0009", Severity::Error, Place{}, {}}};
}

CellRange whole(const pattern::Chart& chart) {
    return {0, 0, chart.width, chart.height()};
}

} // namespace

std::vector<CellRange> pagesOf(int wales, int courses, int mostWales, int mostCourses) {
    const auto parts = [](int size, int most) { return std::max(1, (size + most - 1) / most); };
    const int across = parts(wales, mostWales);
    const int up = parts(courses, mostCourses);
    std::vector<CellRange> pages;
    for (int row = 0; row < up; ++row) {
        const int first = courses * row / up;
        for (int column = 0; column < across; ++column) {
            const int left = wales * column / across;
            pages.push_back(
                {left, first, wales * (column + 1) / across - left, courses * (row + 1) / up - first});
        }
    }
    return pages;
}

Diagnostics writeChartPdf(const ChartSheet& sheet, const QString& path, const SheetProgress& progress) {
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    {
        QPdfWriter pdf(&buffer);
        pdf.setPageSize(QPageSize(QPageSize::A4));
        pdf.setPageMargins(QMarginsF(kMarginMm, kMarginMm, kMarginMm, kMarginMm), QPageLayout::Millimeter);
        pdf.setResolution(72); // points
        pdf.setTitle(sheet.title);
        pdf.setCreator(QStringLiteral("KnittSim"));
        const QRectF page(0, 0, pdf.width(), pdf.height());
        QPainter painter(&pdf);
        SheetPainter sheetPainter(painter, sheet);
        const double legend = sheetPainter.legendHeight(page.width());
        const QRectF upper = page.adjusted(0, SheetPainter::kTitleHeight, 0, -legend - 12);
        const double cell =
            std::min(kLargestCell, sheetPainter.fittingCell(upper.size(), whole(sheet.chart)));
        sheetPainter.paintTitle(page, {});
        sheetPainter.paintChart(upper, whole(sheet.chart), cell);
        sheetPainter.paintLegend(QRectF(page.left(), page.bottom() - legend, page.width(), legend));
        if (cell < kLeastCell) {
            const QRectF area = page.adjusted(0, SheetPainter::kTitleHeight, 0, 0);
            const QSize most = sheetPainter.cellsIn(area.size(), kLeastCell);
            const auto parts = pagesOf(sheet.chart.width, sheet.chart.height(), most.width(), most.height());
            const int pages = static_cast<int>(parts.size()) + 1;
            for (int i = 0; i < pages - 1; ++i) {
                if (progress && !progress(i + 1, pages)) {
                    return ended();
                }
                const CellRange& part = parts[static_cast<std::size_t>(i)];
                pdf.newPage();
                sheetPainter.paintTitle(page, sheetPainter.partText(part, i + 2, pages));
                sheetPainter.paintChart(area, part,
                                        std::min(kLargestCell, sheetPainter.fittingCell(area.size(), part)));
            }
        }
    }
    return write(path, bytes);
}

QImage chartImage(const ChartSheet& sheet, int cell, const SheetProgress& progress) {
    QImage probe(1, 1, QImage::Format_RGB32);
    QPainter measuring(&probe);
    const SheetPainter measure(measuring, sheet);
    const int largest = std::max(sheet.chart.width, sheet.chart.height());
    const double side = std::min<double>(cell, (kMaxSheetSide - 600.0) / largest);
    const QSizeF chart = measure.sizeOf(whole(sheet.chart), side);
    const double width = std::max(chart.width(), 520.0) + 40;
    const double legend = measure.legendHeight(width - 40);
    QImage image(static_cast<int>(width),
                 static_cast<int>(chart.height() + legend + SheetPainter::kTitleHeight + 60),
                 QImage::Format_RGB32);
    image.fill(Qt::white);
    QPainter painter(&image);
    SheetPainter sheetPainter(painter, sheet);
    const QRectF page = QRectF(image.rect()).adjusted(20, 20, -20, -20);
    sheetPainter.paintTitle(page, {});
    const QRectF room(page.left(), page.top() + SheetPainter::kTitleHeight, page.width(), chart.height() + 1);
    if (!sheetPainter.paintChart(room, whole(sheet.chart), side, progress)) {
        return {};
    }
    sheetPainter.paintLegend(QRectF(page.left(), page.bottom() - legend, page.width(), legend));
    return image;
}

Diagnostics writeChartPng(const ChartSheet& sheet, const QString& path, const SheetProgress& progress) {
    const QImage image = chartImage(sheet, 24, progress);
    if (image.isNull()) {
        return ended();
    }
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    image.save(&buffer, "PNG");
    return write(path, bytes);
}

} // namespace knittsim::ui
