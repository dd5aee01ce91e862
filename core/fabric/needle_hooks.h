#pragma once

#include "core/fabric/fabric.h"
#include "core/machine/state.h"

#include <vector>

namespace knittsim::fabric {

/// A needle from which loops hang in the picture of the fabric; places in mm.
struct NeedleHook {
    machine::Needle needle;
    Vec3f place = Vec3f::Zero(); ///< of the yarn in the hook
    Vec3f shaft = Vec3f::Zero(); ///< from there to the visible end of the needle
    bool works = false;          ///< the operation that is shown is done here
};

/// A needle that holds loops.
struct HeldStack {
    machine::Needle needle;
    double pitches = 0; ///< position along the front bed, racking included
    std::vector<machine::LoopIndex> loops;
};

/// All needles with loops, by bed and index.
std::vector<HeldStack> heldStacks(const machine::MachineState& state);

/// Hangs the held loops of a fabric on their needles: `positions` (3 per entry, mm) of their heads move to
/// where the needles stand, above the fabric, front and rear bed apart, a racked bed aside. Needles stand as
/// far apart as the fabric under them is wide, so that it hangs down straight. Where fewer courses are
/// knitted (short rows) the fabric is lifted, so that no held loop is drawn much longer than it is.
std::vector<NeedleHook> hangOnNeedles(const Fabric& fabric, const std::vector<HeldStack>& stacks,
                                      const machine::Operation* working, std::vector<float>& positions);

} // namespace knittsim::fabric
