#pragma once

#include "core/physics/yarn_model/friction_term.h"
#include "core/physics/yarn_model/relax_yarns.h"

namespace knittsim::physics {

/// How exactly friction is to follow the pressure that it comes from.
struct LoadStepOptions {
    YarnRelaxOptions relax;
    int mostLags = 4;        ///< times that pressures are taken anew
    double stillness = 2e-3; ///< largest move of a node by which they count as known, d
};

/// One quasi-static step under friction: from `motion`, where all that rests is at rest, to rest under what
/// has changed since (a load, a pin, a rest length). `friction` is one of the model's terms and is held at
/// the shape at which the step begins; pressures are those of the last shape found. Yarns keep their
/// thickness. The report adds up all rounds; its verdict and residual are those of the last.
YarnRelaxReport makeLoadStep(YarnModel& model, FrictionTerm& friction, Motion& motion,
                             const LoadStepOptions& options = {});

} // namespace knittsim::physics
