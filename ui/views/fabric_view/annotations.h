#pragma once

#include "core/base/diagnostic.h"
#include "core/fabric/needle_hooks.h"
#include "core/geometry/measure.h"
#include "core/geometry/stitch_lattice.h"
#include "ui/views/fabric_view/photograph.h"

#include <QString>

#include <optional>
#include <vector>

namespace knittsim::ui {

/// A problem of the program at a loop.
struct LoopProblem {
    int loop = -1; ///< index into Fabric::loops
    Severity severity = Severity::Info;
};

/// What is written over the picture of the fabric, besides what belongs to the picture itself. Window thread.
struct Annotations {
    bool dimensions = true;
    bool guides = false; ///< lines along courses and wales
    bool marks = true;   ///< of problems
    bool taping = false; ///< clicks set the ends of the measuring tape

    std::optional<geometry::Measurement> size;      ///< of the shape that is shown
    std::optional<geometry::StitchLattice> lattice; ///< likewise; only with guides
    struct Mark {
        Vec3f place; ///< mm
        Severity severity;
    };
    std::vector<Mark> problems;
    std::vector<fabric::NeedleHook> needles; ///< from which loops hang
    bool measures = true;                    ///< dimensions, scale and axes may be painted
    std::vector<Vec3f> tape;                 ///< ends that are set, mm; none, one or two
    std::optional<Vec3f> tapeEnd;            ///< where the second one would be set now
    Photograph photograph;
    int alignClicks = -1; ///< done while it is aligned by two points; -1: it is not
    QString notice;       ///< what the picture is not yet, in words; empty: nothing
    QString alone;        ///< what is shown alone, in words; empty: all
};

/// "12.3 mm (0.48 in)"
QString lengthText(double millimetres);

} // namespace knittsim::ui
