#include "ui/document/course_scale.h"

#include <algorithm>

namespace knittsim::document {

using machine::OperationIndex;

CourseScale::CourseScale(const std::vector<OperationIndex>& courseEnds, OperationIndex operationCount) {
    for (const OperationIndex end : courseEnds) {
        if (end > m_ends.back()) {
            m_ends.push_back(end);
        }
    }
    if (operationCount > m_ends.back()) {
        m_ends.push_back(operationCount);
    }
}

int CourseScale::partOf(OperationIndex step) const {
    const auto found = std::ranges::lower_bound(m_ends, step);
    return found == m_ends.end() ? partCount() : static_cast<int>(found - m_ends.begin());
}

OperationIndex CourseScale::end(int part) const {
    return m_ends[static_cast<std::size_t>(std::clamp(part, 0, partCount()))];
}

OperationIndex CourseScale::firstNear(OperationIndex step) const {
    return end(std::max(0, partOf(step) - 1));
}

OperationIndex CourseScale::lastNear(OperationIndex step) const {
    return end(std::max(1, partOf(step)));
}

} // namespace knittsim::document
