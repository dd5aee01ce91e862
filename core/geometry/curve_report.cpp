#include "core/geometry/curve_report.h"

#include "core/geometry/yarn_curve_builder.h"

#include <algorithm>
#include <cmath>

namespace knittsim::geometry {

namespace {

constexpr double kNeighbours = 3; ///< diameters along a yarn
constexpr double kAsStored = 0.01;

void compareLengths(const fabric::Fabric& fabric, const YarnCurves& curves, CurveReport& report) {
    std::vector<double> length = spanLengths(curves);
    length.resize(fabric.points.size(), 0);
    const auto place = [&](std::size_t p) -> const Vec3& {
        return fabric.machinePositions[static_cast<std::size_t>(fabric.points[p].entry)];
    };
    for (const fabric::Yarn& yarn : fabric.yarns) {
        for (fabric::PointIndex p = yarn.first; p + 1 < yarn.first + yarn.count; ++p) {
            const auto i = static_cast<std::size_t>(p);
            const double stored = fabric.lengths[i];
            if ((place(i + 1) - place(i)).norm() < stored) {
                ++report.spans;
                report.spansAsStored += std::abs(length[i] - stored) <= kAsStored * stored ? 1 : 0;
            }
        }
    }
}

} // namespace

YarnCurves buildMachineCurves(const fabric::Fabric& fabric, std::span<const double> diameterMm) {
    std::vector<float> positions;
    positions.reserve(3 * fabric.machinePositions.size());
    for (const Vec3& p : fabric.machinePositions) {
        for (Eigen::Index i = 0; i < 3; ++i) {
            positions.push_back(static_cast<float>(p[i]));
        }
    }
    return buildYarnCurves(fabric, positions, diameterMm, {.exact = true});
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
