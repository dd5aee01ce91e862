#pragma once

#include "core/base/diagnostic.h"
#include "core/pattern/chart_edit.h"
#include "ui/views/pattern_editor/legend.h"

#include <QColor>
#include <QImage>
#include <QString>

#include <functional>
#include <memory>

namespace knittsim::ui {

/// A yarn of the chart and how much of it the fabric takes.
struct SheetYarn {
    QString carrier;
    QString name;
    QColor colour;
    double metres = 0; ///< 0: not known
    double grams = 0;
};

/// A chart to be printed: black on white, with numbers on all sides, a legend and the yarns.
struct ChartSheet {
    QString title;
    pattern::Chart chart;
    int firstNeedle = 1; ///< of wale 0
    SymbolSet symbols = SymbolSet::Faces;
    std::vector<SheetYarn> yarns; ///< in the order of Chart::yarns
};

/// Told after each page, or each course of a picture; false ends the work.
using SheetProgress = std::function<bool(int done, int all)>;

/// A4. A chart that fits stands on one page with its legend; a larger one is shown as a whole on the first
/// page and in parts on the next ones. Errors: KS0002; KS0009 where it was ended. Written as a whole or not
/// at all.
Diagnostics writeChartPdf(const ChartSheet& sheet, const QString& path, const SheetProgress& progress = {});

/// One picture; cells have at most `cell` pixels, less where the side would pass kMaxSide.
constexpr int kMaxSheetSide = 8000;
/// Null where it was ended.
QImage chartImage(const ChartSheet& sheet, int cell = 24, const SheetProgress& progress = {});
Diagnostics writeChartPng(const ChartSheet& sheet, const QString& path, const SheetProgress& progress = {});

/// Parts of a chart, bottom left first, of which each has at most so many wales and courses; nearly alike in
/// size.
std::vector<pattern::CellRange> pagesOf(int wales, int courses, int mostWales, int mostCourses);

} // namespace knittsim::ui
