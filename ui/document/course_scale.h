#pragma once

#include "core/machine/operation.h"

#include <vector>

namespace knittsim::document {

/// A program cut into its courses, for a slider over courses and one inside the course. Part 0 is the empty
/// machine; part i > 0 are the steps after end(i - 1) up to and with end(i). What comes after the last course
/// is a part of its own.
class CourseScale {
public:
    CourseScale() = default;
    /// `courseEnds`: operations done after each course, rising.
    CourseScale(const std::vector<machine::OperationIndex>& courseEnds,
                machine::OperationIndex operationCount);

    int partCount() const { return static_cast<int>(m_ends.size()) - 1; } ///< without the empty machine
    int partOf(machine::OperationIndex step) const;
    machine::OperationIndex end(int part) const; ///< step after the part
    /// Steps of the part in which `step` lies; at the empty machine those of the first part.
    machine::OperationIndex firstNear(machine::OperationIndex step) const;
    machine::OperationIndex lastNear(machine::OperationIndex step) const;

private:
    std::vector<machine::OperationIndex> m_ends{0};
};

} // namespace knittsim::document
