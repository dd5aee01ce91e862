#pragma once

#include "core/machine/timeline.h"

#include <cstdint>
#include <vector>

namespace knittsim::fabric {

/// Fabric courses of a program: every carriage pass lies in one course, one above the highest loops it knits
/// through. Passes that knit different needles on the same loops (jacquard, intarsia, both beds of a rib)
/// share a course.
struct CourseNumbers {
    std::vector<machine::Pass> passes;
    std::vector<std::int32_t> passOfOperation; ///< index into passes, -1 for operations without yarn
    std::vector<std::int32_t> courseOfPass;

    std::int32_t courseOf(machine::OperationIndex op) const {
        const std::int32_t pass = passOfOperation[static_cast<std::size_t>(op)];
        return pass < 0 ? 0 : courseOfPass[static_cast<std::size_t>(pass)];
    }
};

CourseNumbers numberCourses(const machine::Timeline& timeline);

} // namespace knittsim::fabric
