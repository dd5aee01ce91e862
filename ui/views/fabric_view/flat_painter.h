#pragma once

#include "ui/views/fabric_view/canvas.h"

#include <QSize>

class QPainter;

namespace knittsim::ui {

/// The fabric in two strokes (wide and dark, narrower in the yarn's colour), pieces farther from the viewer
/// first, so that yarns pass over and under each other without a depth buffer. Fills the whole area.
void paintFlat(QPainter& painter, QSize size, const CanvasContent& content);

} // namespace knittsim::ui
