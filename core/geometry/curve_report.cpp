#include "core/geometry/curve_report.h"

#include "core/fabric/machine_shape.h"
#include "core/geometry/yarn_curve_builder.h"

#include <algorithm>
#include <cmath>

namespace knittsim::geometry {

namespace {

constexpr double kNeighbours = 3; ///< diameters along a yarn
constexpr float kAsStored = 0.01F;

/// By piece of yarn: mm of the projection of its shortest way.
std::vector<float> shortestWays(const fabric::Fabric& fabric, std::span<const double> diameterMm) {
    YarnCurveBuilder builder(fabric, diameterMm);
    builder.drawIn();
    const YarnCurves& curves = builder.update(fabric::machinePlaces(fabric));
    std::vector<float> ways;
    for (const YarnPiece& piece : yarnPieces(fabric, curves)) {
        float way = 0;
        for (auto n = static_cast<std::size_t>(piece.firstNode); n < static_cast<std::size_t>(piece.lastNode);
             ++n) {
            way += (curves.nodes[n + 1] - curves.nodes[n]).head<2>().norm();
        }
        ways.push_back(way);
    }
    return ways;
}

void compareLengths(const fabric::Fabric& fabric, const YarnCurves& curves,
                    std::span<const double> diameterMm, CurveReport& report) {
    const auto place = [&](fabric::PointIndex p) -> const Vec3& {
        const fabric::EntryIndex entry = fabric.points[static_cast<std::size_t>(p)].entry;
        return fabric.machinePositions[static_cast<std::size_t>(entry)];
    };
    const std::vector<float> shortestWay = shortestWays(fabric, diameterMm);
    const std::vector<YarnPiece> pieces = yarnPieces(fabric, curves);
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const auto first = static_cast<std::size_t>(pieces[i].firstNode);
        const auto last = static_cast<std::size_t>(pieces[i].lastNode);
        const float stored = pieces[i].storedMm;
        double chord = 0;
        for (fabric::PointIndex p = curves.point[first]; p < curves.point[last]; ++p) {
            chord += (place(p + 1) - place(p)).norm();
        }
        if (chord >= static_cast<double>(stored)) {
            ++report.piecesTooFar;
        } else {
            ++report.pieces;
            const float off = std::abs(curves.arc[last] - curves.arc[first] - stored);
            const bool asStored = off <= kAsStored * stored;
            report.piecesAsStored += asStored ? 1 : 0;
            report.piecesOutOfReach += !asStored && shortestWay[i] > stored ? 1 : 0;
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
    compareLengths(fabric, curves, diameterMm, report);
    return report;
}

} // namespace knittsim::geometry
