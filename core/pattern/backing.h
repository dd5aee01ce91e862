#pragma once

#include "core/pattern/chart.h"

#include <vector>

/// The back of a coloured fabric on two beds: the yarns that the front does not show are knitted into
/// stitches of the rear bed instead of floating.
namespace knittsim::pattern {

/// Of the rear needles, each so many-th knits a ladder: no float of two colours is longer.
constexpr int kLadderStep = 4;

/// Wales, rising, whose rear needle `yarn` knits as the back of a course with isBacked(); none elsewhere.
///
/// - Birdseye: every second one. Which of the two rows it is changes from yarn to yarn and from course to
/// course.
/// - LadderBack: every kLadderStep-th one, with one yarn a course: of the yarns that the cell does not show
/// they
///   take turns; where the course has one yarn only, that one.
///
/// The back leaves out cells that say themselves what the rear needle does, and those without yarn.
std::vector<int> backingOf(const Chart& chart, int course, int yarn);

} // namespace knittsim::pattern
