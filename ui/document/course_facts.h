#pragma once

#include "core/machine/program.h"

#include <functional>
#include <optional>
#include <vector>

namespace knittsim::document {

/// What the machine does in one course, for the columns beside a chart.
struct CourseFacts {
    struct Feed {
        machine::CarrierIndex carrier = 0;
        machine::Direction direction = machine::Direction::Right;

        bool operator==(const Feed&) const = default;
    };
    std::vector<Feed> feeds;          ///< each carrier once, in the order of its last pass
    double racking = 0;               ///< pitches, at its last loop
    std::optional<double> stitchSize; ///< stitch number, or the machine's own unit, at its last loop

    bool operator==(const CourseFacts&) const = default;
};

/// `courseOf` gives the course of an operation that makes a loop, -1 where it has none.
std::vector<CourseFacts> courseFacts(const machine::Program& program, int courses,
                                     const std::function<int(machine::OperationIndex)>& courseOf);

} // namespace knittsim::document
