#pragma once

#include "core/pattern/chart.h"

#include <optional>

namespace knittsim::ui {

/// A part of a chart on the system's clipboard, as the text of a project: it goes from window to window and
/// into a text editor.
void copyToClipboard(const pattern::Chart& part);

/// Nothing when the clipboard holds something else.
std::optional<pattern::Chart> partOnClipboard();

} // namespace knittsim::ui
