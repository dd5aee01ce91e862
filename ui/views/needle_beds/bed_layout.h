#pragma once

#include "core/machine/bed_picture.h"

#include <QRectF>

namespace knittsim::ui {

/// Where things of the beds seen from above lie on the widget, in its pixels. The rear bed is above.
struct BedLayout {
    QRectF area;       ///< of the whole view from above
    double centre = 0; ///< position in the middle, pitches
    double pitch = 20; ///< pixels a needle pitch
    double textHeight = 16;

    double xOf(double pitches) const;
    double pitchesAt(double x) const;
    /// Positions that are visible, with a rim for what reaches in from outside.
    machine::BedWindow window() const;

    double bedHeight() const;
    double gap() const; ///< between the two beds
    /// The line where the hooks of a bed are at rest.
    double vergeY(machine::Bed bed) const;
    double gapCentreY() const;
    double rearNumbersY() const;
    double frontNumbersY() const;
    /// A point `u` pixels from the verge of a bed towards the other bed.
    QPointF at(machine::Bed bed, double pitches, double u) const;

    double stroke() const { return 0.72 * gap(); } ///< pixels between a needle at rest and at its highest
    double hook() const { return 0.09 * gap(); }   ///< from a needle's tip to the yarn in its hook
    double yarnWidth() const;

    /// The needle under a point; sliders count as the needles they lie on.
    machine::Needle needleAt(QPointF point, double rack) const;
};

} // namespace knittsim::ui
