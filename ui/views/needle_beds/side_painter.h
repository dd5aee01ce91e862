#pragma once

#include "ui/views/needle_beds/bed_scene.h"

#include <QPainterPath>

namespace knittsim::ui {

/// Draws the two beds in section at one place: the V of the beds, needles with hook and latch, loops, the
/// yarn. The front bed is on the left.
class SidePainter {
public:
    /// `pitches`: position of the section along the front bed. Works on the needles of the scene nearest to
    /// it.
    SidePainter(QPainter& painter, const QRectF& area, const BedScene& scene, double pitches);

    /// `caption` says what happens.
    void paint(const QString& caption);

private:
    /// One bed's axis: from its verge along the needle, and the side on which the hook opens.
    struct Axis {
        QPointF verge;
        QPointF along;
        QPointF up;

        QPointF at(double u, double height) const { return verge + along * u + up * height; }
    };

    void paintBed(const Axis& axis);
    void paintNeedle(const Axis& axis, const machine::SeenNeedle& needle);
    void paintSlider(const Axis& axis, const machine::SeenNeedle& slider);
    void paintLoops(const Axis& axis, const machine::SeenNeedle& needle);
    void paintLoop(QPointF centre, QPointF along, double half, const machine::SeenLoop& loop);
    void paintFlight();
    void paintFabric();
    void paintFeeders();
    void paintName(machine::Bed bed);
    void paintCaption(const QString& caption);
    const machine::SeenNeedle* nearest(machine::Bed bed) const;
    const Axis& axisOf(machine::Bed bed) const { return machine::isFront(bed) ? m_front : m_rear; }
    double tipOf(const machine::SeenNeedle& needle) const;
    QPointF loopCentre(const Axis& axis, const machine::SeenNeedle& needle, const machine::SeenLoop& loop,
                       double stacked) const;

    QPainter& m_painter;
    QRectF m_whole; ///< with the lines of text
    QRectF m_area;  ///< of the drawing
    const BedScene& m_scene;
    BedColours m_colours;
    double m_pitches;
    double m_size;    ///< pixels, the scale of everything
    double m_stroke;  ///< pixels of the longest stroke
    double m_hook;    ///< pixels from a needle's tip to the yarn in its hook
    double m_yarn;    ///< width of the yarn
    QPointF m_fabric; ///< where the loops come together below the verges
    Axis m_front;
    Axis m_rear;
};

} // namespace knittsim::ui
