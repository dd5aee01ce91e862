#include "ui/views/pattern_editor/legend.h"

#include <QColor>
#include <QCoreApplication>
#include <QPainter>

#include <algorithm>

namespace knittsim::ui {

namespace {

using document::StitchKind;
using document::StitchMark;

QString nameOf(const StitchMark& mark) {
    const auto tr = [](const char* text) { return QCoreApplication::translate("knittsim::ui", text); };
    if (mark.dropped) {
        return tr("Loop that was dropped");
    }
    if (mark.parents > 1) {
        return tr("Stitch through several loops");
    }
    if (mark.moved != 0) {
        return mark.moved > 0 ? tr("Loop goes to the right") : tr("Loop goes to the left");
    }
    if (mark.otherBed) {
        return mark.rear ? tr("Loop goes to the front bed") : tr("Loop goes to the rear bed");
    }
    switch (mark.kind) {
    case StitchKind::CastOn:
        return mark.rear ? tr("Loop on an empty needle, rear bed") : tr("Loop on an empty needle, front bed");
    case StitchKind::Knit:
        return mark.rear ? tr("Stitch on the rear bed (purl)") : tr("Stitch on the front bed (knit)");
    case StitchKind::Tuck:
        return mark.rear ? tr("Tuck on the rear bed") : tr("Tuck on the front bed");
    case StitchKind::Split:
        break;
    }
    return tr("Split: stitch and loop on the other bed");
}

/// One place for each name above.
std::vector<StitchMark> examples() {
    std::vector<StitchMark> marks;
    for (const StitchKind kind :
         {StitchKind::Knit, StitchKind::Tuck, StitchKind::CastOn, StitchKind::Split}) {
        marks.push_back({.kind = kind});
        marks.push_back({.kind = kind, .rear = true});
    }
    marks.push_back({.rear = false, .otherBed = true});
    marks.push_back({.rear = true, .otherBed = true});
    marks.push_back({.moved = -1});
    marks.push_back({.moved = 1});
    marks.push_back({.parents = 2});
    marks.push_back({.dropped = true});
    return marks;
}

/// What of a mark its symbol shows; a mark may show several things.
std::vector<StitchMark> partsOf(const StitchMark& mark) {
    std::vector<StitchMark> parts{{.kind = mark.kind, .rear = mark.rear}};
    if (mark.dropped) {
        parts.push_back({.dropped = true});
    }
    if (mark.parents > 1) {
        parts.push_back({.parents = 2});
    }
    if (mark.moved != 0) {
        parts.push_back({.moved = static_cast<std::int8_t>(mark.moved > 0 ? 1 : -1)});
    } else if (mark.otherBed) {
        parts.push_back({.rear = mark.rear, .otherBed = true});
    }
    return parts;
}

} // namespace

std::vector<LegendEntry> legendOf(const document::StitchGrid& grid, SymbolSet symbols) {
    std::vector<StitchMark> seen;
    StitchMark last;
    for (std::size_t i = 0; i < grid.loopCount(); ++i) {
        const StitchMark mark = grid.markOf(static_cast<document::LoopIndex>(i));
        if (i > 0 && mark == last) {
            continue;
        }
        last = mark;
        for (const StitchMark& part : partsOf(mark)) {
            if (std::ranges::find(seen, part) == seen.end()) {
                seen.push_back(part);
            }
        }
    }
    std::vector<LegendEntry> legend;
    for (const StitchMark& mark : examples()) {
        if (std::ranges::find(seen, mark) != seen.end()) {
            legend.push_back(
                {nameOf(mark), [mark, symbols](QPainter& painter, const QRectF& rect, const QColor& ink) {
                     paintSymbol(painter, rect, mark, symbols, ink);
                 }});
        }
    }
    return legend;
}

LegendEntry yarnEntry(const QString& name, const QColor& colour) {
    return {name, [colour](QPainter& painter, const QRectF& rect, const QColor&) {
                painter.fillRect(rect, colour);
            }};
}

} // namespace knittsim::ui
