#include "ui/document/course_facts.h"

#include <algorithm>

namespace knittsim::document {

using machine::OperationKind;

std::vector<CourseFacts> courseFacts(const machine::Program& program, int courses,
                                     const std::function<int(machine::OperationIndex)>& courseOf) {
    std::vector<CourseFacts> facts(static_cast<std::size_t>(std::max(courses, 0)));
    double racking = 0;
    std::optional<double> stitchSize;
    for (std::size_t i = 0; i < program.operations.size(); ++i) {
        const machine::Operation& operation = program.operations[i];
        if (operation.kind == OperationKind::Rack) {
            racking = operation.value;
        } else if (operation.kind == OperationKind::StitchNumber ||
                   operation.kind == OperationKind::StitchSize) {
            stitchSize = operation.value;
        }
        if (!machine::makesLoop(operation.kind)) {
            continue;
        }
        const int course = courseOf(static_cast<machine::OperationIndex>(i));
        if (course < 0 || course >= courses) {
            continue;
        }
        CourseFacts& of = facts[static_cast<std::size_t>(course)];
        of.racking = racking;
        of.stitchSize = stitchSize;
        for (const machine::CarrierIndex carrier : operation.carriers) {
            const CourseFacts::Feed feed{carrier, operation.direction};
            if (of.feeds.empty() || of.feeds.back() != feed) {
                std::erase_if(of.feeds, [&](const auto& other) { return other.carrier == carrier; });
                of.feeds.push_back(feed);
            }
        }
    }
    return facts;
}

} // namespace knittsim::document
