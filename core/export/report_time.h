#pragma once

#include "core/machine/profile.h"
#include "core/machine/program.h"

namespace knittsim::exports {

/// How long a machine with one knitting system takes, estimated:
///
///     seconds = knit way / knit speed + transfer way / transfer speed + strokes x turn
///
/// Every pass with yarn is one stroke. Loops that move from one bed at one racking are one stroke in either
/// direction. Where a pass begins on the side on which the carriage is not, it first comes over empty. The
/// way of a stroke goes from its first to its last needle and by the carrier's stop beyond them at both ends.
struct KnittingTime {
    int knitStrokes = 0;
    int transferStrokes = 0;
    int emptyStrokes = 0;
    double knitMetres = 0; ///< empty strokes among them
    double transferMetres = 0;
    machine::ProfileSpeed speed; ///< of the profile

    int strokes() const { return knitStrokes + transferStrokes + emptyStrokes; }
    double seconds() const {
        return knitMetres / speed.knitMetresPerSecond + transferMetres / speed.transferMetresPerSecond +
               strokes() * speed.turnSeconds;
    }
};

KnittingTime estimateTime(const machine::Program& program, const machine::MachineProfile& profile);

} // namespace knittsim::exports
