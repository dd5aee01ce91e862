#pragma once

#include "core/physics/spring_law.h"

namespace knittsim::physics {

/// The preview (PHYSICS 1): quadratic springs with the rest lengths of strand.h, and the fabric's own
/// stiffness (stitch_mesh.h), all constants from the yarn's EA and EI. Each constant is a pure number.
struct PreviewOptions {
    /// An arc of yarn of length a with both ends built in resists a change of its chord with 180 EI / a^3
    /// (even connectors, PHYSICS-REFERENCE 3.5), in line with the stretch EA / length.
    double arcStiffness = 180;
    /// A strand between two guided ends: 12 EI / a^3 across (odd connectors, PHYSICS-REFERENCE 3.5).
    double shearStiffness = 12;
    /// A strand bent at an end that is built in: 4 EI / a per radian.
    double bendStiffness = 4;
    /// Plates (plate_term.h): half their gap in diameters of the thickest yarn - a rib is 3.4 to 4.8
    /// diameters thick (PHYSICS-REFERENCE 3.3) - and their stiffness against the mean spring.
    double plateHalfGap = 2.4;
    double plateStiffness = 3e-3;
};

/// The paper's energies on the yarn itself: rest length = yarn length. Constants as in the paper, without
/// theory.
struct PaperOptions {
    SpringLaw law{.pull = PullLaw::Quartic, .exponent = 1, .table = {}};
    double pull = 1;   ///< C_p of equation 8 (mN/mm^3), or C_k of equation 2 (mN/mm^a)
    double repel = 1;  ///< C_r of equation 7 (mN/mm)
    double bend = 0.1; ///< C_b of equation 6 (uJ)
};

struct ModelOptions {
    enum class Mode { Preview, Paper } mode = Mode::Preview;
    PreviewOptions preview{};
    PaperOptions paper{};
};

} // namespace knittsim::physics
