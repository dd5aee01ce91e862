#pragma once

#include "core/physics/yarn_model/chains.h"

#include <vector>

namespace knittsim::physics {

/// A repeat of knit and purl stitches, as many wales wide and courses high.
struct KnitPurl {
    int wales = 1;
    int courses = 1;
    /// +1 knit, -1 purl (seen from the front); course after course from the bottom, left to right.
    std::vector<int> faces{1};

    /// Of any stitch; the repeat goes on for ever.
    int at(int wale, int course) const;

    /// 'k' and 'p', one string a course, from the bottom.
    static KnitPurl fromRows(const std::vector<const char*>& rows);
};

/// How the first shape of a cell is drawn.
struct KnitCellStart {
    int nodesPerLoop = 24;
    double widthFactor = 4.0;  ///< kw = loop length / wale spacing to start from
    double heightFactor = 5.4; ///< kc = loop length / course spacing to start from
};

/// One repeat as a periodic cell, each course a closed chain, with a curve that is topologically right for
/// any pattern (PHYSICS-REFERENCE 6.5). `loopLengths` by stitch as in `faces`, in d; yarn moves freely within
/// a course, so only their sum by course counts. The factors give the proportions; the size is such that the
/// curve is as long as the yarn.
YarnChains knitCell(const KnitPurl& pattern, const std::vector<double>& loopLengths, const RodYarn& yarn,
                    const KnitCellStart& start = {});

} // namespace knittsim::physics
