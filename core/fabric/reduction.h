#pragma once

#include "core/fabric/fabric.h"

#include <span>
#include <vector>

namespace knittsim::fabric {

struct ReductionOptions {
    /// Loops still on needles hang on a stitch holder. Without it they run as well.
    bool stitchHolder = true;
};

/// Loops that nothing holds, in the order in which they run: step 0 are those that were let go, the next step
/// those that lost their hold with them, and so on down the ladder.
struct Runs {
    std::vector<std::vector<LoopIndex>> steps;

    std::size_t loopCount() const;
};

/// A loop holds while it hangs on a needle or a loop that holds is drawn through it. Meissner & Eberhardt
/// 1998, section 4. Of a fabric that is partly reduced already: the runs that go on from there.
Runs findRuns(const Fabric& fabric, const ReductionOptions& options = {});

struct ReducedFabric {
    Fabric fabric;                       ///< loop numbers as before; removed loops have no points
    std::vector<EntryIndex> entryBefore; ///< by new entry: the entry of the fabric before, for positions
};

/// Takes the loops of the first `steps` steps out (all when negative). A yarn then runs straight past a
/// removed loop, as the rung of a ladder; the yarn of the loop itself goes in equal parts to the neighbouring
/// loops of its yarn (section 5), where it hangs slack.
ReducedFabric removeRuns(const Fabric& fabric, const Runs& runs, int steps = -1);

/// Two reductions of one fabric, `more` with all that `less` took out and more: by entry of `more` the entry
/// of `less`.
std::vector<EntryIndex> pairEntries(const ReducedFabric& more, const ReducedFabric& less);

/// Positions (3 per entry) of other entries: those of `entries`, one after the other.
std::vector<float> pickPositions(std::span<const EntryIndex> entries, std::span<const float> positions);

} // namespace knittsim::fabric
