#pragma once

#include "core/physics/yarn_model/cell_load_term.h"
#include "core/physics/yarn_model/relax_cell.h"

#include <functional>
#include <vector>

namespace knittsim::physics {

struct PullPoint {
    double strain = 0;
    double stress = 0; ///< force by width at rest across the pull, EI/d^3
    double width = 0;  ///< of the repeat, d
    double height = 0;
    double energy = 0; ///< elastic, of the repeat, EI/d
    bool back = false;
};

/// A strip of fabric between two grips, far from both: one side of a repeat is drawn longer in equal steps
/// and let back, the other one is free.
struct PullOptions {
    CellLoadTerm::Side side = CellLoadTerm::Width; ///< Width: along courses, Height: along wales
    double strain = 0.6;                           ///< largest, of the side at rest
    int steps = 20;                                ///< up to it
    bool back = true;                              ///< and in as many steps back, while it still pulls
    YarnRelaxOptions relax;
    std::function<void(const PullPoint&)> onPoint{}; ///< told at once of every point; may be empty
};

struct PullResult {
    std::vector<PullPoint> points;                       ///< the first one at rest
    StopRule::Verdict verdict = StopRule::Verdict::GoOn; ///< of the last step; others did not come to rest
    StrandAudit audit;                                   ///< at the largest strain reached
    std::vector<LoopFault> faults;                       ///< there

    /// Area under the points up to the largest strain and back, EI/d^3.
    double work(bool back) const;
};

/// Pulls a repeat that has settled. The friction of its yarns acts, so that the way back is lower than the
/// way up; which way it was strained at rest is not known, so it begins without strain.
PullResult pullCell(const KnitPurl& pattern, const CellShape& rest, const PullOptions& options);

} // namespace knittsim::physics
