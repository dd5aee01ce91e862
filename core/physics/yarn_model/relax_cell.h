#pragma once

#include "core/physics/yarn_model/cell_release.h"
#include "core/physics/yarn_model/knit_cell.h"
#include "core/physics/yarn_model/loop_certificate.h"

#include <optional>
#include <vector>

namespace knittsim::physics {

struct CellOptions {
    KnitCellStart start;
    /// The first curve is so many times as wide and high as `start`, or the machine, has it. Its yarn gives
    /// the size, so only their ratio counts.
    double wider = 1;
    double higher = 1;
    YarnRelaxOptions relax;
    /// Pull to the middle plane, by length of yarn and distance, EI/d^4: a fabric that lies flat. 0:
    /// floating.
    double flattening = 0;
    /// With it the cell comes from a machine and the yarn's friction holds it; without it there is no
    /// friction and the first curve's proportions are where it comes from.
    std::optional<MachineHold> machine;
};

/// A repeat at rest, in d.
struct CellShape {
    double waleSpacing = 0;
    double courseSpacing = 0;
    double loopLength = 0; ///< mean, of yarn at rest
    double thickness = 0;  ///< from the outside of the lowest to that of the highest yarn
    double energy = 0;     ///< elastic, EI/d
    YarnRelaxReport relax;
    std::vector<LoopFault> faults; ///< stitches whose certificate does not hold
    YarnChains chains;
    int nodesPerLoop = 24;
    Vector shape;
};

/// Settles one repeat with its width and height as unknowns; a yarn with set takes it then, and the repeat
/// settles again. `loopLengths` by stitch, d.
CellShape relaxCell(const KnitPurl& pattern, const std::vector<double>& loopLengths, const RodYarn& yarn,
                    const CellOptions& options = {});

/// The smallest repeat that the pattern and its loop lengths consist of, as a pattern and lengths of its own.
struct Repeat {
    KnitPurl pattern;
    std::vector<double> loopLengths;
};
Repeat smallestRepeat(const KnitPurl& pattern, const std::vector<double>& loopLengths);

} // namespace knittsim::physics
