#pragma once

#include "ui/render/fabric_scene.h"

#include <QColor>
#include <QPointF>

class QPainter;

namespace knittsim::ui {

/// A bonding point as the OpenGL pictures show it, `pixels` wide: for the legend, and where there is no
/// OpenGL. `way`: of the strand in front on the screen; `ground` interrupts the strand behind it.
void paintMarker(QPainter& painter, render::Marker::Kind kind, QPointF centre, double pixels, QPointF way,
                 const QColor& ground, bool dark);

/// Width of a marker at this scale, pixels; that of a crossing is twice as much.
double markerPixels(double millimetresPerPixel);

} // namespace knittsim::ui
