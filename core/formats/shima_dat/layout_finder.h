#pragma once

#include "core/formats/shima_dat/layout.h"
#include "core/formats/shima_dat/raster.h"

#include <optional>

namespace knittsim::formats::shima_dat {

/// Where the passes stand in a picture.
struct Frame {
    int firstRow = 0;
    int endRow = 0;      ///< behind the last pass
    int leftMark = 0;    ///< column of the mark of option line L1
    int rightMark = 0;   ///< column of the mark of option line R1
    int firstNeedle = 1; ///< needle number of the first slot

    int firstColumn() const { return leftMark + kGap + 1; }
    int endColumn() const { return rightMark - kGap; }
};

/// Finds the rows that have option lines, whatever margin is around them. Nothing when there is none or when
/// they do not follow each other.
std::optional<Frame> findFrame(const Raster& raster);

/// Option values of a pass.
Options optionsOf(const Raster& raster, const Frame& frame, int row);

} // namespace knittsim::formats::shima_dat
