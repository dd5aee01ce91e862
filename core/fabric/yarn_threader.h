#pragma once

#include "core/fabric/course_numbers.h"
#include "core/fabric/entry_table.h"
#include "core/fabric/leg_crossings.h"

namespace knittsim::fabric {

/// Runs along every yarn and lays down its bonding points, the yarn lengths between them, the yarn courses
/// and the crossings. Needs Fabric::made, ::loops and ::pitchMm; fills ::points, ::lengths, ::yarns,
/// ::courses, ::crossings,
/// ::entryCount and the points of ::loops.
void threadYarns(Fabric& fabric, const CourseNumbers& numbers, const LegCrossings& crossings,
                 EntryTable& entries);

} // namespace knittsim::fabric
