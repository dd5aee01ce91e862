#pragma once

#include "core/machine/program.h"
#include "core/pattern/chart.h"

/// Regular fabrics of any size, for tests, benchmarks and as the ground of samples. All sizes are at least 1.
namespace knittsim::pattern {

Chart plainChart(int wales, int courses);
/// `knits` wales on the front bed, then `purls` wales on the rear bed, and so on.
Chart ribChart(int wales, int courses, int knits = 1, int purls = 1);
/// Courses alternate between the beds.
Chart garterChart(int wales, int courses);
/// Knit and purl like a chess board, 1 x 1.
Chart seedChart(int wales, int courses);
/// Knit and purl like a chess board, fields of 1 wale x 2 courses.
Chart mossChart(int wales, int courses);

/// Programs of these charts with one carrier, needles 1 to `wales`, the first course knitted on empty
/// needles, the last loops held. wales x courses loops, none of them tucked.
machine::Program makePlain(int wales, int courses);
machine::Program makeRib(int wales, int courses, int knits = 1, int purls = 1);
machine::Program makeGarter(int wales, int courses);
machine::Program makeSeed(int wales, int courses);
machine::Program makeMoss(int wales, int courses);

} // namespace knittsim::pattern
