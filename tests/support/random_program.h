#pragma once

#include "core/machine/program.h"

#include <cstdint>

namespace knittsim::test {

struct RandomProgramOptions {
    std::uint32_t seed = 1;
    int operations = 300; ///< at least; the pass that is begun is ended, and the carriers are taken out
    int firstNeedle = -4; ///< of the working area on the front bed
    int width = 12;       ///< needles of the working area
    int carriers = 3;
    int maxRack = 2;  ///< pitches to either side
    int maxLoops = 4; ///< on one needle
    bool rearBed = true;
    bool transfers = true; ///< xfer, split and whole-pitch racking; needs the rear bed
    bool quarterRacks = true;
    bool drops = true;
    bool extensions = true; ///< x-stitch-number, x-vis-color and an unknown one
};

/// A valid program: passes of knit, tuck, miss and split over both beds, transfers only between needles that
/// face each other, racks, drops. No needle comes to hold more than `maxLoops` loops, every carrier is
/// brought in before its first use and out at the end. The same options give the same program on every
/// machine.
machine::Program randomProgram(const RandomProgramOptions& options);

} // namespace knittsim::test
