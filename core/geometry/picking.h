#pragma once

#include "core/geometry/yarn_curve.h"

#include <optional>
#include <span>

namespace knittsim::geometry {

/// Half line from a viewer's eye; `direction` is unit.
struct Ray {
    Vec3f origin = Vec3f::Zero();
    Vec3f direction = -Vec3f::UnitZ();
};

/// Where a ray meets a round segment of yarn.
struct SegmentHit {
    float share = 0; ///< along the segment, 0..1
    float depth = 0; ///< mm along the ray to the yarn's surface
};

/// The segment from `a` to `b` as a tube of this radius with round ends; nothing when the ray misses it.
std::optional<SegmentHit> meetSegment(const Ray& ray, const Vec3f& a, const Vec3f& b, float radius);

/// What a ray meets first.
struct Pick {
    fabric::PointIndex point = -1; ///< nearest bonding point along the yarn
    fabric::EntryIndex entry = -1; ///< its entry
    machine::LoopIndex loop = -1;  ///< its loop
    Vec3f place = Vec3f::Zero();   ///< on the centreline, mm
    float depth = 0;               ///< mm along the ray
};

/// The first yarn that a ray meets, or nothing. `diameterMm` by carrier; `tolerance` mm is added to every
/// radius. Linear in the number of nodes.
std::optional<Pick> pickYarn(const fabric::Fabric& fabric, const YarnCurves& curves,
                             std::span<const double> diameterMm, const Ray& ray, float tolerance = 0);

/// Where the ray meets the plane through `point` with this normal; nothing when it runs along it.
std::optional<Vec3f> meetPlane(const Ray& ray, const Vec3f& point, const Vec3f& normal);

} // namespace knittsim::geometry
