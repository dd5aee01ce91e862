#pragma once

#include "core/pattern/chart_edit.h"

#include <functional>

namespace knittsim::pattern {

/// A chart for which `fails` still holds and from which no course, wale, move or stitch other than knit can
/// be taken. `fails` must hold for `chart` itself.
inline Chart shrinkChart(Chart chart, const std::function<bool(const Chart&)>& fails) {
    bool smaller = true;
    const auto attempt = [&](const std::function<void(Chart&)>& change) {
        Chart changed = chart;
        change(changed);
        if (changed != chart && fails(changed)) {
            chart = std::move(changed);
            smaller = true;
        }
    };
    while (smaller) {
        smaller = false;
        for (int c = chart.height() - 1; c >= 0; --c) {
            attempt([&](Chart& changed) { removeCourses(changed, c, 1); });
        }
        for (int w = chart.width - 1; w >= 0; --w) {
            attempt([&](Chart& changed) { removeWales(changed, w, 1); });
        }
        for (int c = 0; c < chart.height(); ++c) {
            attempt([&](Chart& changed) { changed.course(c).moves.clear(); });
            attempt([&](Chart& changed) { changed.course(c).colours = ColourMethod::Float; });
            for (int w = 0; w < chart.width; ++w) {
                attempt([&](Chart& changed) { changed.at(w, c).stitch = Stitch::Knit; });
                attempt([&](Chart& changed) { changed.at(w, c).yarn = 0; });
            }
        }
    }
    return chart;
}

} // namespace knittsim::pattern
