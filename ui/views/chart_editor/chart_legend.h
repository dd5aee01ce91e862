#pragma once

#include "core/pattern/chart.h"
#include "ui/views/pattern_editor/legend.h"

namespace knittsim::ui {

/// The symbols that this chart shows, each once; yarns are not among them.
std::vector<LegendEntry> legendOf(const pattern::Chart& chart, SymbolSet symbols);

} // namespace knittsim::ui
