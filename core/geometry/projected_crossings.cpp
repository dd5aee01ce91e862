#include "core/geometry/projected_crossings.h"

#include "core/geometry/segment_grid.h"

#include <tuple>

namespace knittsim::geometry {

namespace {

constexpr float kTiltX = 1.3e-3F;
constexpr float kTiltY = 0.7e-3F;

struct Segment {
    std::int32_t node = 0;
    Vec3f from;
    Vec3f way;
};

float cross(const Vec3f& a, const Vec3f& b) {
    return a.x() * b.y() - a.y() * b.x();
}

Vec3f tilted(const Vec3f& p) {
    return {p.x() + kTiltX * p.z(), p.y() + kTiltY * p.z(), p.z()};
}

std::vector<Segment> segmentsOf(const YarnCurves& curves) {
    std::vector<Segment> segments;
    segments.reserve(curves.nodes.size());
    for (const YarnCurves::Range& yarn : curves.yarns) {
        for (std::int32_t n = yarn.first; n + 1 < yarn.first + yarn.count; ++n) {
            const Vec3f from = tilted(curves.nodes[static_cast<std::size_t>(n)]);
            const Vec3f to = tilted(curves.nodes[static_cast<std::size_t>(n) + 1]);
            if (from.allFinite() && to.allFinite()) {
                segments.push_back({n, from, to - from});
            }
        }
    }
    return segments;
}

} // namespace

std::vector<ProjectedCrossing> projectCrossings(const YarnCurves& curves) {
    const std::vector<Segment> segments = segmentsOf(curves);
    std::vector<SegmentGrid::Box> boxes;
    boxes.reserve(segments.size());
    double length = 0;
    for (const Segment& s : segments) {
        const Vec3f to = s.from + s.way;
        boxes.push_back({std::min(s.from.x(), to.x()), std::min(s.from.y(), to.y()),
                         std::max(s.from.x(), to.x()), std::max(s.from.y(), to.y())});
        length += static_cast<double>(s.way.head<2>().norm());
    }
    const auto mean =
        static_cast<float>(length / static_cast<double>(std::max<std::size_t>(1, segments.size())));
    const SegmentGrid grid(boxes, std::max(2 * mean, 1e-3F));

    std::vector<ProjectedCrossing> crossings;
    grid.forEachPair(boxes, [&](std::size_t i, std::size_t k) {
        const Segment& a = segments[i];
        const Segment& b = segments[k];
        const float det = cross(a.way, b.way);
        if (det == 0 || std::abs(a.node - b.node) < 2) {
            return;
        }
        const Vec3f between = b.from - a.from;
        const float s = cross(between, b.way) / det;
        const float t = cross(between, a.way) / det;
        if (s < 0 || s >= 1 || t < 0 || t >= 1) {
            return;
        }
        const float gap = a.from.z() + s * a.way.z() - b.from.z() - t * b.way.z();
        const int sign = det > 0 ? 1 : -1;
        if (gap > 0) {
            crossings.push_back({a.node, b.node, s, t, gap, sign});
        } else {
            crossings.push_back({b.node, a.node, t, s, -gap, -sign});
        }
    });
    std::ranges::sort(crossings, {}, [](const ProjectedCrossing& c) { return std::tuple(c.over, c.under); });
    return crossings;
}

} // namespace knittsim::geometry
