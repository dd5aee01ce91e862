#include "core/geometry/strand_distance.h"

#include "core/base/segment_distance.h"
#include "core/geometry/segment_grid.h"

namespace knittsim::geometry {

StrandDistance smallestDistance(const YarnCurves& curves, double limitMm, double apartMm) {
    std::vector<std::int32_t> nodes;
    std::vector<std::int32_t> yarns;
    std::vector<SegmentGrid::Box> boxes;
    const auto reach = static_cast<float>(0.5 * limitMm);
    const auto at = [&](std::int32_t n) -> const Vec3f& { return curves.nodes[static_cast<std::size_t>(n)]; };
    for (std::size_t y = 0; y < curves.yarns.size(); ++y) {
        const YarnCurves::Range& yarn = curves.yarns[y];
        for (std::int32_t n = yarn.first; n + 1 < yarn.first + yarn.count; ++n) {
            const Vec3f low = at(n).cwiseMin(at(n + 1));
            const Vec3f high = at(n).cwiseMax(at(n + 1));
            if (low.allFinite() && high.allFinite()) {
                nodes.push_back(n);
                yarns.push_back(static_cast<std::int32_t>(y));
                boxes.push_back({low.x() - reach, low.y() - reach, high.x() + reach, high.y() + reach});
            }
        }
    }
    StrandDistance nearest{.mm = limitMm};
    const SegmentGrid grid(boxes, static_cast<float>(std::max(2 * limitMm, 1e-3)));
    grid.forEachPair(boxes, [&](std::size_t i, std::size_t k) {
        const std::int32_t a = nodes[i];
        const std::int32_t b = nodes[k];
        if (std::max(std::min(at(a).z(), at(a + 1).z()) - std::max(at(b).z(), at(b + 1).z()),
                     std::min(at(b).z(), at(b + 1).z()) - std::max(at(a).z(), at(a + 1).z())) >=
            static_cast<float>(nearest.mm)) {
            return;
        }
        if (yarns[i] == yarns[k] &&
            (std::abs(a - b) < 3 ||
             std::abs(curves.arc[static_cast<std::size_t>(a)] - curves.arc[static_cast<std::size_t>(b)]) <
                 static_cast<float>(apartMm))) {
            return;
        }
        const double mm = closestPoints(at(a).cast<double>(), at(a + 1).cast<double>(), at(b).cast<double>(),
                                        at(b + 1).cast<double>())
                              .distance;
        if (mm < nearest.mm) {
            nearest = {mm, a, b};
        }
    });
    return nearest;
}

} // namespace knittsim::geometry
