#pragma once

#include "core/machine/program.h"

#include <cstdint>

namespace knittsim::test {

/// The bed on the other side of the gap, sliders to sliders.
machine::Bed otherBed(machine::Bed bed);

/// The program as a person on the left hand side of a mirror would write it.
machine::Program mirrored(machine::Program program);

/// The program for somebody who stands behind the machine and calls the rear bed the front one.
machine::Program turnedOver(machine::Program program);

/// Before every rack all carriers go far beyond the loops, to either side: no yarn hangs between needles that
/// move.
machine::Program withCarriersAsideAtRacks(machine::Program program);

/// Changes the order of neighbouring operations that are independent, as often as `tries` random places
/// allow. Two operations are independent when both knit, tuck, miss, split, transfer or drop, they share no
/// carrier, and the stretches of the bed that they touch have no place in common. The stretch of an operation
/// runs from where its carriers stand to its needle; of a transfer or a drop it is the place of its needle.
/// So neither passes anything that the other one moves or makes.
machine::Program withSwaps(machine::Program program, int tries, std::uint32_t seed);

/// Something that leaves the fabric as it is.
enum class Nothing {
    RackThereAndBack,
    RackInSteps,               ///< a rack in one go becomes one in two steps
    TransferThereAndBack,      ///< all loops of a needle, to an empty needle
    TransferBeforeItsOpposite, ///< of the loops there, before all go the other way
    MissThereAndBack,          ///< of a carrier that stands alone on its side of its needle
    DropOfNothing,             ///< an empty needle
};

/// Puts it in at a random place where the machine can do it; the program itself when there is none.
machine::Program with(Nothing nothing, machine::Program program, std::uint32_t seed);

/// A random tuck of one carrier is made on the empty needle that faces its own one, and transferred. The
/// program itself when there is none.
machine::Program withTuckFromTheOtherBed(machine::Program program, std::uint32_t seed);

} // namespace knittsim::test
