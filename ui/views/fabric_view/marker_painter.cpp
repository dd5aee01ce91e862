#include "ui/views/fabric_view/marker_painter.h"

#include "ui/render/look.h"

#include <QPainter>

#include <algorithm>
#include <cmath>

namespace knittsim::ui {

namespace {

QColor toQt(yarn::Colour c) {
    return {c.r, c.g, c.b};
}

void paintCrossing(QPainter& painter, QPointF centre, double pixels, QPointF way, const QColor& ground,
                   const QColor& colour) {
    const double length = std::hypot(way.x(), way.y());
    painter.setPen(Qt::NoPen);
    painter.setBrush(ground);
    painter.drawEllipse(centre, 0.31 * pixels, 0.31 * pixels);
    painter.setPen(QPen(colour, 0.26 * pixels, Qt::SolidLine, Qt::FlatCap));
    const QPointF half = length > 0 ? 0.5 * pixels / length * way : QPointF(0.13 * pixels, 0);
    painter.drawLine(centre - half, centre + half);
}

} // namespace

void paintMarker(QPainter& painter, render::Marker::Kind kind, QPointF centre, double pixels, QPointF way,
                 const QColor& ground, bool dark) {
    const render::MeshColours colours = render::meshColours(dark);
    if (kind == render::Marker::Crossing) {
        paintCrossing(painter, centre, 2 * pixels, way, ground, toQt(colours.crossing));
        return;
    }
    painter.setPen(QPen(toQt(colours.head), 0.2 * pixels));
    painter.setBrush(kind == render::Marker::Bond ? QBrush(toQt(colours.foot)) : QBrush(Qt::NoBrush));
    painter.drawEllipse(centre, 0.4 * pixels, 0.4 * pixels);
}

double markerPixels(double millimetresPerPixel) {
    return std::clamp(render::kMarkerMm / millimetresPerPixel,
                      static_cast<double>(render::kLeastMarkerPixels),
                      static_cast<double>(render::kMostMarkerPixels));
}

} // namespace knittsim::ui
