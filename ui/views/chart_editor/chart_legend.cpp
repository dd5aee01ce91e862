#include "ui/views/chart_editor/chart_legend.h"

#include "ui/views/chart_editor/stitch_picture.h"

#include <QColor>
#include <QCoreApplication>
#include <QPainter>

#include <algorithm>
#include <array>

namespace knittsim::ui {

namespace {

using pattern::LoopMove;
using pattern::Stitch;

/// Moved loops as the eye tells them apart.
struct MoveKind {
    const char* name;
    std::vector<LoopMove> moves;
    int cells; ///< that the drawing needs
};

std::vector<MoveKind> moveKinds() {
    return {
        {QT_TRANSLATE_NOOP("knittsim::ui", "Two together, leaning right; the hole beside it is an eyelet"),
         {{0, 1}},
         2},
        {QT_TRANSLATE_NOOP("knittsim::ui", "Two together, leaning left; the hole beside it is an eyelet"),
         {{1, 0}},
         2},
        {QT_TRANSLATE_NOOP("knittsim::ui", "Cable: loops change places; the upper line lies in front"),
         {{0, 1}, {1, 0}},
         2}};
}

std::array<bool, 3> movesUsed(const pattern::Chart& chart) {
    std::array<bool, 3> used{};
    for (const pattern::Course& course : chart.courses) {
        for (const LoopMove& move : course.moves) {
            used[isStacked(course.moves, move) ? (move.to > move.from ? 0 : 1) : 2] = true;
        }
    }
    return used;
}

} // namespace

std::vector<LegendEntry> legendOf(const pattern::Chart& chart, SymbolSet symbols) {
    std::vector<LegendEntry> legend;
    for (int i = 0; i < pattern::kStitches; ++i) {
        const auto stitch = static_cast<Stitch>(i);
        if (std::ranges::find(chart.cells, stitch, &pattern::Cell::stitch) != chart.cells.end()) {
            legend.push_back({stitchName(stitch),
                              [stitch, symbols](QPainter& painter, const QRectF& rect, const QColor& ink) {
                                  paintStitch(painter, rect, stitch, symbols, ink);
                              }});
        }
    }
    const std::vector<MoveKind> kinds = moveKinds();
    const std::array<bool, 3> used = movesUsed(chart);
    for (std::size_t i = 0; i < kinds.size(); ++i) {
        if (used[i]) {
            legend.push_back(
                {QCoreApplication::translate("knittsim::ui", kinds[i].name),
                 [kind = kinds[i], symbols](QPainter& painter, const QRectF& rect, const QColor& ink) {
                     const double width = rect.width() / kind.cells;
                     const auto cellOf = [&](int wale) {
                         return QRectF(rect.left() + wale * width, rect.top(), width, rect.height());
                     };
                     const QColor ground = ink.lightness() < 128 ? Qt::white : QColor(30, 30, 32);
                     paintMoves(painter, kind.moves, cellOf, symbols, ink, ground);
                 }});
        }
    }
    return legend;
}

} // namespace knittsim::ui
