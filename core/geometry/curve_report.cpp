#include "core/geometry/curve_report.h"

#include "core/fabric/machine_shape.h"
#include "core/geometry/yarn_curve_builder.h"

#include <algorithm>
#include <cmath>

namespace knittsim::geometry {

namespace {

constexpr double kNeighbours = 3; ///< diameters along a yarn
constexpr float kAsStored = 0.01F;

void compareLengths(const fabric::Fabric& fabric, const YarnCurves& curves, CurveReport& report) {
    const auto place = [&](fabric::PointIndex p) -> const Vec3& {
        const fabric::EntryIndex entry = fabric.points[static_cast<std::size_t>(p)].entry;
        return fabric.machinePositions[static_cast<std::size_t>(entry)];
    };
    for (const YarnPiece& piece : yarnPieces(fabric, curves)) {
        const auto first = static_cast<std::size_t>(piece.firstNode);
        const auto last = static_cast<std::size_t>(piece.lastNode);
        double shortest = 0;
        for (fabric::PointIndex p = curves.point[first]; p < curves.point[last]; ++p) {
            shortest += (place(p + 1) - place(p)).norm();
        }
        if (shortest < static_cast<double>(piece.storedMm)) {
            ++report.pieces;
            const float off = std::abs(curves.arc[last] - curves.arc[first] - piece.storedMm);
            report.piecesAsStored += off <= kAsStored * piece.storedMm ? 1 : 0;
        }
    }
}

} // namespace

YarnCurves buildMachineCurves(const fabric::Fabric& fabric, std::span<const double> diameterMm) {
    return buildYarnCurves(fabric, fabric::machinePlaces(fabric), diameterMm, {.exact = true});
}

CurveReport inspectCurves(const fabric::Fabric& fabric, const YarnCurves& curves,
                          std::span<const double> diameterMm) {
    CurveReport report;
    report.crossings = auditCrossings(fabric, curves, projectCrossings(curves));
    report.certificate = certifyTopology(fabric, curves);
    const double diameter = diameterMm.empty() ? 1 : *std::ranges::max_element(diameterMm);
    report.nearest = smallestDistance(curves, diameter, kNeighbours * diameter);
    compareLengths(fabric, curves, report);
    return report;
}

} // namespace knittsim::geometry
