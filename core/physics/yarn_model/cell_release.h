#pragma once

#include "core/physics/yarn_model/load_step.h"
#include "core/physics/yarn_model/yarn_units.h"

namespace knittsim::physics {

/// How a machine holds a fabric: under friction its rest depends on where it comes from.
struct MachineHold {
    double waleSpacing = 0; ///< needle pitch, d
    double takeDown = 0;    ///< force along each wale, EI/d^2
    int steps = 24;         ///< in which both are let go; fewer than 12 are too rough
};

/// Take-down of flat and circular machines, 15 to 25 grams a needle (Spencer, Knitting Technology, on
/// relaxation). Cells of acrylic come to the same rest, within 2 %, from half of it and from 5/4.
constexpr double kTakeDownMilliNewton = 196;

MachineHold machineHold(double pitchMm, const YarnUnits& units);

/// Settles a cell of `wales` x `courses` as it happens in a fabric: first without friction at the width it is
/// held at and under the take-down, as needles and sinkers move the yarn all the time; then the forces that
/// held it go to nothing, in ever smaller steps, under friction. `friction` is one of the model's terms, or
/// null.
YarnRelaxReport releaseCell(YarnModel& model, FrictionTerm* friction, Motion& motion, int wales, int courses,
                            const MachineHold& hold, const YarnRelaxOptions& options = {});

} // namespace knittsim::physics
