#pragma once

#include "core/geometry/crossing_events.h"

#include <vector>

namespace knittsim::geometry {

/// What the crossings of two pieces are and what they should be.
struct CrossingFault {
    enum class Kind {
        Missing,     ///< a recorded crossing or a loop drawn through another is not there
        Unexplained, ///< strands cross of which nothing says who is in front
        WrongOrder   ///< the layers say who is in front, and it is the other one
    } kind = Kind::Missing;
    CurvePiece a;
    CurvePiece b;
    std::int32_t node = -1; ///< of the first crossing of the two; -1 when they have none
};

struct CrossingAudit {
    std::size_t expected = 0; ///< crossings that the fabric's books ask for
    std::size_t found = 0;    ///< of these, with the right sign and the right strand in front
    std::size_t layered = 0;  ///< further ones: layers that lie over each other, in the right order
    std::vector<CrossingFault> faults;
    /// By projected crossing: +1 the right strand is in front, -1 the other one has to be, 0 not known.
    std::vector<std::int8_t> order;
};

/// Compares the signed crossings of the projected curves with the fabric's books. Two crossings of the same
/// strands with the same one in front and opposite signs cancel (second Reidemeister move).
CrossingAudit auditCrossings(const fabric::Fabric& fabric, const YarnCurves& curves,
                             const std::vector<ProjectedCrossing>& crossings);

} // namespace knittsim::geometry
