#pragma once

#include "core/fabric/fabric.h"

#include <span>
#include <vector>

namespace knittsim::geometry {

/// A rectangle of stitches, both ends included; wales and courses are counted from 0.
struct Region {
    int firstWale = 0;
    int lastWale = 1 << 30;
    int firstCourse = 0;
    int lastCourse = 1 << 30;
};

/// Sizes of a region, following its courses and wales, mm. A size is 0 where the region is too small to have
/// it.
struct Measurement {
    int wales = 0; ///< in the region
    int courses = 0;
    int loops = 0;
    double waleSpacingMm = 0;   ///< mean distance of neighbouring wales along the courses
    double courseSpacingMm = 0; ///< mean distance of neighbouring courses along the wales
    double widthMm = 0;         ///< wales times wale spacing
    double heightMm = 0;        ///< courses times course spacing
    double loopLengthMm = 0;    ///< mean yarn of a loop as the machine fed it
};

/// By loop: its wale. Wales are the needle numbers that made loops, counted from the left without gaps.
std::vector<int> waleNumbers(const fabric::Fabric& fabric);

/// `positions`: 3 per entry, mm.
Measurement measure(const fabric::Fabric& fabric, std::span<const float> positions,
                    const Region& region = {});

} // namespace knittsim::geometry
