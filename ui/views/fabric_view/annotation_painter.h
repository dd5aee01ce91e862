#pragma once

#include "ui/views/fabric_view/annotations.h"
#include "ui/views/fabric_view/canvas.h"

#include <QColor>
#include <QSize>

class QPainter;

namespace knittsim::ui {

/// Colours of what is written over a picture.
struct OverlayInk {
    QColor ink;
    QColor ground;
    QColor course; ///< of lines along courses
    QColor wale;
    QColor needle; ///< of the front bed
    QColor rearNeedle;
};
OverlayInk overlayInk(bool dark);

/// Width with wales and height with courses in 10 cm, along the lower and the left edge of the fabric, while
/// it is seen from the front or the back; inside a picture of `size`.
void paintDimensions(QPainter& painter, QSize size, const CanvasContent& content,
                     const Annotations& annotations, const OverlayInk& ink);

/// Numbered lines along courses and wales, as many as there is room for.
void paintGuides(QPainter& painter, const CanvasContent& content, const Annotations& annotations,
                 const OverlayInk& ink);

/// A sign at each loop with a problem: colour and letter tell the severity.
void paintProblems(QPainter& painter, const CanvasContent& content, const Annotations& annotations);

/// The needles from which loops hang, with bed and number.
void paintNeedles(QPainter& painter, const CanvasContent& content, const Annotations& annotations,
                  const OverlayInk& ink);

/// The measuring tape with its length.
void paintTape(QPainter& painter, const CanvasContent& content, const Annotations& annotations,
               const OverlayInk& ink);

/// Every how many courses or wales there is room for a line: 1, 2, 5, 10, ...
int guideStep(double spacingMm, double millimetresPerPixel);

} // namespace knittsim::ui
