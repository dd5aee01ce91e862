#pragma once

#include "core/machine/operation.h"

namespace knittsim::formats::passes {

/// How one family of machines puts operations together into passes.
struct PassRules {
    const char* refusal;         ///< rule that says what cannot be written: {0} what, {1} why
    bool hook;                   ///< has an inserting hook
    bool sliders;                ///< has sliders
    bool tucksWithKnits;         ///< one bed may knit and tuck in one pass
    bool splitsWithKnits;        ///< a bed may knit and split in one pass
    bool presser;                ///< has a fabric presser
    bool missesAreSoft;          ///< a miss only carries the yarn, it is no work of a needle
    bool oneStitchNumber;        ///< a pass has one stitch number, else every needle has its own
    machine::Direction outwards; ///< in which carriers leave
    double interleavedFraction;  ///< of a racking at which both beds can work every needle
    double maxRack;              ///< to either side, pitches
    int maxStitchNumber;         ///< stitch numbers are 0 to this
    int stitch;                  ///< number before the program names one
    int transferStitch;          ///< the same for transfers
    double speed;                ///< before the program names one
    double maxSpeed;             ///< speeds are whole numbers from 0 to this
    double roller;               ///< take-down of a pass before the program names one
    int maxCarriersInSet;
};

} // namespace knittsim::formats::passes
