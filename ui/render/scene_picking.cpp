#include "ui/render/scene_picking.h"

#include <cmath>

namespace knittsim::render {

namespace {

struct Hit {
    const Chunk* chunk = nullptr;
    std::size_t node = 0;
    geometry::SegmentHit segment;
};

Vec3f placeOf(const SceneFrame& frame, std::size_t node) {
    return Vec3f::Map(frame.nodes[node].data());
}

bool passesNear(const geometry::Ray& ray, const Chunk& chunk, float margin) {
    const Vec3f offset = chunk.centre - ray.origin;
    const float along = offset.dot(ray.direction);
    const float reach = chunk.reach + margin;
    return offset.squaredNorm() - along * along <= reach * reach;
}

/// Of the bonding points before and after a node, the one nearer along the yarn.
fabric::PointIndex nearestPoint(const SceneFrame& frame, const geometry::YarnCurves::Range& yarn,
                                std::size_t node) {
    const std::vector<std::uint32_t>& owner = frame.topology->owner;
    const auto arc = [&](std::size_t n) { return frame.nodes[n][3]; };
    std::size_t before = node;
    while (before > static_cast<std::size_t>(yarn.first) && owner[before - 1] == owner[node]) {
        --before;
    }
    std::size_t after = node;
    while (after + 1 < static_cast<std::size_t>(yarn.first + yarn.count) && owner[after] == owner[node]) {
        ++after;
    }
    const std::size_t nearer = arc(node) - arc(before) <= arc(after) - arc(node) ? node : after;
    return static_cast<fabric::PointIndex>(owner[nearer]);
}

} // namespace

std::optional<geometry::Pick> pickScene(const SceneFrame& frame, const fabric::Fabric& fabric,
                                        const geometry::Ray& ray, float tolerance,
                                        const std::optional<Section>& section) {
    std::optional<Hit> best;
    for (const Chunk& chunk : frame.chunks) {
        const float yarnRadius = frame.style == DrawStyle::Mesh ? 0 : 0.5F * frame.diameters[chunk.carrier];
        const float radius = yarnRadius + tolerance;
        if (!passesNear(ray, chunk, radius)) {
            continue;
        }
        const auto first = static_cast<std::size_t>(chunk.firstNode);
        for (std::size_t n = first; n + 1 < first + static_cast<std::size_t>(chunk.count); ++n) {
            const auto hit = geometry::meetSegment(ray, placeOf(frame, n), placeOf(frame, n + 1), radius);
            const bool cut = hit && section && section->cuts(ray.origin + hit->depth * ray.direction);
            if (hit && !cut && (!best || hit->depth < best->segment.depth)) {
                best = Hit{&chunk, n, *hit};
            }
        }
    }
    if (!best) {
        return std::nullopt;
    }
    const std::size_t node = best->node + (best->segment.share < 0.5F ? 0 : 1);
    for (const geometry::YarnCurves::Range& yarn : frame.topology->yarns) {
        if (best->chunk->firstNode >= yarn.first && best->chunk->firstNode < yarn.first + yarn.count) {
            const fabric::PointIndex p = nearestPoint(frame, yarn, node);
            const fabric::BondingPoint& point = fabric.points[static_cast<std::size_t>(p)];
            return geometry::Pick{p, point.entry, point.loop, placeOf(frame, node), best->segment.depth};
        }
    }
    return std::nullopt;
}

} // namespace knittsim::render
