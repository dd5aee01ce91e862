#include "core/geometry/picking.h"

#include <algorithm>
#include <cmath>

namespace knittsim::geometry {

namespace {

/// Of the bonding points before and after a node, the one nearer along the yarn.
fabric::PointIndex nearestPoint(const YarnCurves& curves, const YarnCurves::Range& yarn, std::int32_t node) {
    const auto pointAt = [&](std::int32_t n) { return curves.point[static_cast<std::size_t>(n)]; };
    const auto arcAt = [&](std::int32_t n) { return curves.arc[static_cast<std::size_t>(n)]; };
    const fabric::PointIndex here = pointAt(node);
    std::int32_t begin = node;
    while (begin > yarn.first && pointAt(begin - 1) == here) {
        --begin;
    }
    std::int32_t end = node;
    while (end < yarn.first + yarn.count - 1 && pointAt(end) == here) {
        ++end;
    }
    return arcAt(node) - arcAt(begin) <= arcAt(end) - arcAt(node) ? here : pointAt(end);
}

} // namespace

std::optional<SegmentHit> meetSegment(const Ray& ray, const Vec3f& a, const Vec3f& b, float radius) {
    const auto flat = [&](const Vec3f& v) -> Vec3f { return v - v.dot(ray.direction) * ray.direction; };
    const Vec3f offset = a - ray.origin;
    const Vec3f way = b - a;
    const Vec3f flatOffset = flat(offset);
    const Vec3f flatWay = flat(way);
    const float length2 = flatWay.squaredNorm();
    const float share = length2 > 0 ? std::clamp(-flatOffset.dot(flatWay) / length2, 0.0F, 1.0F) : 0;
    const float inside2 = radius * radius - (flatOffset + share * flatWay).squaredNorm();
    if (!(inside2 >= 0)) {
        return std::nullopt;
    }
    const float depth = (offset + share * way).dot(ray.direction) - std::sqrt(inside2);
    return depth > 0 ? std::optional<SegmentHit>({share, depth}) : std::nullopt;
}

std::optional<Pick> pickYarn(const fabric::Fabric& fabric, const YarnCurves& curves,
                             std::span<const double> diameterMm, const Ray& ray, float tolerance) {
    std::optional<Pick> best;
    const YarnCurves::Range* bestYarn = nullptr;
    std::int32_t bestNode = 0;
    for (const YarnCurves::Range& yarn : curves.yarns) {
        const float diameter =
            yarn.carrier < diameterMm.size() ? static_cast<float>(diameterMm[yarn.carrier]) : 0.3F;
        const float radius = 0.5F * diameter + tolerance;
        for (std::int32_t n = yarn.first; n + 1 < yarn.first + yarn.count; ++n) {
            const Vec3f& a = curves.nodes[static_cast<std::size_t>(n)];
            const Vec3f& b = curves.nodes[static_cast<std::size_t>(n) + 1];
            const auto hit = meetSegment(ray, a, b, radius);
            if (hit && (!best || hit->depth < best->depth)) {
                best = Pick{.place = a + hit->share * (b - a), .depth = hit->depth};
                bestYarn = &yarn;
                bestNode = hit->share < 0.5F ? n : n + 1;
            }
        }
    }
    if (best) {
        best->point = nearestPoint(curves, *bestYarn, bestNode);
        const fabric::BondingPoint& point = fabric.points[static_cast<std::size_t>(best->point)];
        best->entry = point.entry;
        best->loop = point.loop;
    }
    return best;
}

std::optional<Vec3f> meetPlane(const Ray& ray, const Vec3f& point, const Vec3f& normal) {
    const float slope = ray.direction.dot(normal);
    if (std::abs(slope) < 1e-6F) {
        return std::nullopt;
    }
    const float t = (point - ray.origin).dot(normal) / slope;
    return t > 0 ? std::optional<Vec3f>(ray.origin + t * ray.direction) : std::nullopt;
}

} // namespace knittsim::geometry
