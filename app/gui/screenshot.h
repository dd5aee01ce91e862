#pragma once

#include "ui/window/main_window.h"

#include <QString>

namespace knittsim::app {

/// Saves a picture of the window once its fabric is at rest (or the opening failed), at the latest after
/// `seconds`, and ends the program: 0 when the picture was written, else 1.
void takeScreenshot(ui::MainWindow& window, const QString& path, double seconds);

} // namespace knittsim::app
