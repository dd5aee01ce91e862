#include "ui/render/finer_curves.h"

#include <algorithm>

namespace knittsim::render {

namespace {

/// Between `b` and `c` at `t` in [0, 1); the tangent at a node is half the way between its neighbours.
Vec3f onSpline(const Vec3f& a, const Vec3f& b, const Vec3f& c, const Vec3f& d, float t) {
    const Vec3f quadratic = 2 * a - 5 * b + 4 * c - d;
    const Vec3f cubic = 3 * (b - c) + d - a;
    return b + 0.5F * t * ((c - a) + t * (quadratic + t * cubic));
}

/// Calls visit(node, next node, share of the way) for every new node; the last one of a yarn has no way.
template<class Visit>
void forEachNode(const geometry::YarnCurves::Range& yarn, int times, const Visit& visit) {
    const auto first = static_cast<std::size_t>(yarn.first);
    const std::size_t last = first + static_cast<std::size_t>(yarn.count) - 1;
    for (std::size_t n = first; n < last; ++n) {
        for (int i = 0; i < times; ++i) {
            visit(n, n + 1, static_cast<float>(i) / static_cast<float>(times));
        }
    }
    visit(last, last, 0.0F);
}

} // namespace

geometry::YarnCurves finer(const geometry::YarnCurves& curves, int times) {
    geometry::YarnCurves fine;
    for (const geometry::YarnCurves::Range& yarn : curves.yarns) {
        const auto first = static_cast<std::size_t>(yarn.first);
        const std::size_t last = first + static_cast<std::size_t>(std::max(1, yarn.count)) - 1;
        const auto begin = static_cast<std::int32_t>(fine.nodes.size());
        forEachNode(yarn, times, [&](std::size_t n, std::size_t next, float t) {
            const auto between = [n, next, t](const auto& values) {
                return (1 - t) * values[n] + t * values[next];
            };
            const std::size_t before = std::max(n, first + 1) - 1;
            const std::size_t after = std::min(next + 1, last);
            fine.nodes.push_back(
                onSpline(curves.nodes[before], curves.nodes[n], curves.nodes[next], curves.nodes[after], t));
            fine.point.push_back(curves.point[n]);
            fine.piece.push_back(curves.piece[n]);
            fine.arc.push_back(between(curves.arc));
            fine.height.push_back(between(curves.height));
            fine.normal.emplace_back(between(curves.normal));
        });
        fine.yarns.push_back({begin, static_cast<std::int32_t>(fine.nodes.size()) - begin, yarn.carrier});
    }
    return fine;
}

std::vector<float> finer(const geometry::YarnCurves& curves, std::span<const float> values, int times) {
    std::vector<float> fine;
    for (const geometry::YarnCurves::Range& yarn : curves.yarns) {
        forEachNode(yarn, times, [&](std::size_t n, std::size_t next, float t) {
            fine.push_back((1 - t) * values[n] + t * values[next]);
        });
    }
    return fine;
}

} // namespace knittsim::render
