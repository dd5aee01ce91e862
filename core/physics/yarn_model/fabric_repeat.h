#pragma once

#include "core/fabric/fabric.h"
#include "core/physics/yarn_model/relax_cell.h"

#include <optional>

namespace knittsim::physics {

/// The part of a fabric that is nothing but knit and purl stitches of one yarn, and what it repeats.
struct FabricRepeat {
    Repeat repeat; ///< loop lengths in mm, with the yarn that runs from bed to bed
    machine::CarrierIndex carrier = 0;
    int firstCourse = 0; ///< of the fabric
    int wales = 0;       ///< of the part, edge wales left out
    int courses = 0;
};

/// Looks at the longest run of courses in which every stitch is drawn through the one below it on the same
/// needle number. Nothing when that is less than half of the fabric or less than two repeats each way, or
/// when a repeat is larger than kLargestRepeat: a repeat would then say little of the fabric.
std::optional<FabricRepeat> findFabricRepeat(const fabric::Fabric& fabric);

constexpr int kLargestRepeat = 24; ///< wales and courses

} // namespace knittsim::physics
