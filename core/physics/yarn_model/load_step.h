#pragma once

#include "core/physics/yarn_model/friction_term.h"
#include "core/physics/yarn_model/relax_yarns.h"

namespace knittsim::physics {

struct LoadStepOptions {
    YarnRelaxOptions relax;
    double mostSlip = 0.2;   ///< d: how far contacts may slip before friction looks where they are now
    double stillness = 5e-3; ///< d: contacts that slip less have come to rest
    int mostPieces = 100;
};

/// One quasi-static step under friction: from `motion`, where all rests that can, to rest under what has
/// changed since (a load, a pin, a rest length). It goes in pieces, each from where the last one ended, with
/// pressures taken anew as contacts slip; so yarns that jump do so slowly, as if in honey, and stop where
/// friction first can hold them. Yarns keep their thickness.
///
/// `friction` is one of the model's terms, or null: then the yarns just settle. The report adds up all
/// pieces; its verdict and residual are those of the last, StepLimit when they did not suffice.
YarnRelaxReport makeLoadStep(YarnModel& model, FrictionTerm* friction, Motion& motion,
                             const LoadStepOptions& options = {});

/// Adds friction to a model of these chains; null when none of the yarns has any.
FrictionTerm* addFriction(YarnModel& model, const YarnChains& chains);

} // namespace knittsim::physics
