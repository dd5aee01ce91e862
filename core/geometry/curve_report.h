#pragma once

#include "core/geometry/crossing_audit.h"
#include "core/geometry/strand_distance.h"
#include "core/geometry/topology_certificate.h"

namespace knittsim::geometry {

/// How exact the yarn curves of a fabric are where it hangs on the machine.
struct CurveReport {
    CrossingAudit crossings;
    TopologyCertificate certificate;
    StrandDistance nearest; ///< of strands more than three diameters of yarn apart
    /// Pieces of yarn between feet and heads that lie farther apart than it is long, on the way over the
    /// places where it is crossed. No curve through these places is as short: nearly all are legs of loops
    /// that wait while other passes are knitted.
    std::size_t piecesTooFar = 0;
    std::size_t pieces = 0; ///< of yarn between feet and heads that lie nearer together than it is long
    std::size_t piecesAsStored = 0; ///< of these, as long as the stored yarn within 1 %
    /// Of the others: longer than that already in the projection of the shortest way, straight from place to
    /// place but for the room that strands need beside each other. The grid of the machine forces it on them.
    std::size_t piecesOutOfReach = 0;
};

/// Curves at Fabric::machinePositions with CurveOptions::exact. `diameterMm` by carrier.
YarnCurves buildMachineCurves(const fabric::Fabric& fabric, std::span<const double> diameterMm);

/// `curves` as made by buildMachineCurves.
CurveReport inspectCurves(const fabric::Fabric& fabric, const YarnCurves& curves,
                          std::span<const double> diameterMm);

} // namespace knittsim::geometry
