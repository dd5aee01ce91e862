#pragma once

#include "core/fabric/fabric.h"

#include <vector>

namespace knittsim::fabric {

/// The last loop that the machine had made after an operation; the first one before there was any.
LoopIndex latestLoop(const Fabric& fabric, OperationIndex operation);

/// Where the courses of a fabric lie on the machine, mm above the first.
class CourseHeights {
public:
    /// A course is as high as the yarn of its legs reaches; courses with crossings or with loops that moved
    /// to other needles have longer legs and are higher.
    explicit CourseHeights(const Fabric& fabric);

    double courseMm() const { return m_courseMm; } ///< of a course without crossings

    /// `course` may lie between two courses, or beyond the last.
    double at(double course) const;

private:
    double m_courseMm = 0;
    std::vector<double> m_bottom; ///< by course, and the top of the last
};

} // namespace knittsim::fabric
