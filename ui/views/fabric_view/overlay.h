#pragma once

#include "ui/views/fabric_view/canvas.h"

#include <QWidget>

namespace knittsim::ui {

/// Badge of the side that is seen, legends of the mesh and of the colours, scale bar, axes, a ring round the
/// selected bonding point, signs at stitches, pins and a person's pull, painted over the picture. Lets all
/// events through.
class Overlay : public QWidget {
    Q_OBJECT

public:
    Overlay(QWidget* parent, const CanvasContent& content);

    /// Shown in the middle while there is nothing to see, and as a note above the scale bar.
    void setMessage(const QString& message);

    /// "technical face", "technical back", or empty when the fabric is seen from the side.
    QString sideText() const;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void paintBadge(QPainter& painter) const;
    int paintLegend(QPainter& painter, int top) const;
    void paintColours(QPainter& painter, int top) const;
    void paintPins(QPainter& painter) const;
    void paintPull(QPainter& painter) const;
    QPointF onScreen(const Vec3f& place) const;
    void paintMark(QPainter& painter) const;
    void paintFlags(QPainter& painter) const;
    void paintScale(QPainter& painter) const;
    void paintAxes(QPainter& painter) const;
    void paintMessage(QPainter& painter) const;
    QColor ink() const;
    QColor ground() const;

    const CanvasContent& m_content;
    QString m_message;
};

/// The longest of 1, 2, 5, 10, 20, ... and 0.1, 0.2, 0.5 mm that takes at most `mostPixels`.
double scaleBarMm(double millimetresPerPixel, double mostPixels);

} // namespace knittsim::ui
