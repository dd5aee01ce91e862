#include "core/fabric/pass_levels.h"

#include <algorithm>
#include <tuple>

namespace knittsim::fabric {

std::vector<float> passLevels(const Fabric& fabric) {
    struct Pass {
        std::int32_t course;
        OperationIndex operation;
        const YarnCourse* points;
    };
    std::vector<Pass> passes;
    passes.reserve(fabric.courses.size());
    for (const YarnCourse& course : fabric.courses) {
        if (course.count > 0) {
            const LoopIndex loop = fabric.points[static_cast<std::size_t>(course.first)].loop;
            passes.push_back(
                {course.course, fabric.made.loops[static_cast<std::size_t>(loop)].operation, &course});
        }
    }
    std::ranges::sort(passes, {}, [](const Pass& p) { return std::tuple(p.course, p.operation); });

    std::vector<float> levels(fabric.loops.size(), 0);
    for (auto first = passes.begin(); first != passes.end();) {
        const auto last =
            std::find_if(first, passes.end(), [&](const Pass& p) { return p.course != first->course; });
        const auto count = static_cast<float>(last - first);
        for (auto pass = first; pass != last; ++pass) {
            const float level = 0.5F * static_cast<float>(pass - first) / count;
            for (PointIndex p = pass->points->first; p < pass->points->first + pass->points->count; ++p) {
                levels[static_cast<std::size_t>(fabric.points[static_cast<std::size_t>(p)].loop)] = level;
            }
        }
        first = last;
    }
    return levels;
}

} // namespace knittsim::fabric
