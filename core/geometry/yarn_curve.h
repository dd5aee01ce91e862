#pragma once

#include "core/base/vec3.h"
#include "core/fabric/fabric.h"

#include <span>
#include <vector>

namespace knittsim::geometry {

/// Smooth centrelines of all yarns of a fabric, sampled densely enough to draw.
struct YarnCurves {
    std::vector<Vec3f> nodes;              ///< yarn after yarn, mm
    std::vector<fabric::PointIndex> point; ///< by node: bonding point at or before it
    std::vector<fabric::PointIndex>
        piece;                 ///< by node: bonding point whose leg, float or half sinker it is on
    std::vector<float> arc;    ///< by node: arc length along its yarn, mm
    std::vector<Vec3f> normal; ///< by node: about unit, the fabric's own; empty unless asked for
    std::vector<float> height; ///< by node: mm over the smoothed fabric along normal; empty likewise
    struct Range {
        std::int32_t first = 0;
        std::int32_t count = 0;
        machine::CarrierIndex carrier = 0;
    };
    std::vector<Range> yarns;
};

/// How a curve is drawn through the bonding points.
struct CurveOptions {
    int samplesPerSegment = 4; ///< nodes between two control points
    bool exact = false;        ///< see YarnCurveBuilder::makeExact
    bool withSurface = false;  ///< fill YarnCurves::normal and ::height
};

/// Curves through the bonding points at `positions` (3 per entry, mm). At a bonding point the new loop comes
/// through the old one from the far side of its bed; the curves are set off to the sides that this says by
/// about half of `diameterMm` (by carrier), so that they never meet in a point.
YarnCurves buildYarnCurves(const fabric::Fabric& fabric, std::span<const float> positions,
                           std::span<const double> diameterMm, const CurveOptions& options = {});

/// Nodes [firstNode, lastNode] of one yarn and the yarn that belongs between them.
struct YarnPiece {
    std::int32_t firstNode = 0;
    std::int32_t lastNode = 0;
    float storedMm = 0;
};

/// The yarn between neighbouring feet and heads. Where others cross it in between is for it to find: a
/// crossing holds no yarn.
std::vector<YarnPiece> yarnPieces(const fabric::Fabric& fabric, const YarnCurves& curves);

/// Index into `yarns` of the yarn that a node lies on.
std::size_t yarnAt(const YarnCurves& curves, std::int32_t node);

/// By bonding point, mm: of the curve from it to the next one of its yarn. As long as the last point drawn.
std::vector<double> spanLengths(const YarnCurves& curves);

} // namespace knittsim::geometry
