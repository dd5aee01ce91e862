#pragma once

#include "core/fabric/fabric.h"
#include "core/geometry/projected_crossings.h"

#include <vector>

namespace knittsim::geometry {

/// A piece of yarn between two places where it may cross others: half a loop with half of the sinker before
/// or after it, or the crossed part of a float (named by the loop that it leads to).
struct CurvePiece {
    machine::LoopIndex loop = -1;
    fabric::Piece piece = fabric::Piece::LeftLeg;
    auto operator<=>(const CurvePiece&) const = default;
};

/// One crossing of two pieces a < b: who is in front, and the sign when both pieces run with time (legs from
/// foot to head, floats as the carrier went).
struct CrossingEvent {
    CurvePiece a;
    CurvePiece b;
    bool aOver = false;
    int sign = 0;
    float place = 0;              ///< along a, with time; wanted ones: -1 recorded, 0 and 1 of a stitch
    fabric::PointIndex over = -1; ///< bonding points that the strands are nearest to
    fabric::PointIndex under = -1;
    std::int32_t node = -1;
    std::size_t index = 0; ///< of the projected crossing
    bool kink = false;     ///< wanted, but good without: it can be straightened
};

/// What the books of a fabric ask for, and what its projected curves show, as crossings of the same pieces.
class CrossingEvents {
public:
    /// Both must outlive it.
    CrossingEvents(const fabric::Fabric& fabric, const YarnCurves& curves);

    /// Sorted by pieces and place.
    std::vector<CrossingEvent> wanted();
    std::vector<CrossingEvent> found(const std::vector<ProjectedCrossing>& crossings);

    CurvePiece pieceOf(fabric::PointIndex p) const;

    /// The sign with both strands along their yarns.
    int yarnSign(const CrossingEvent& e) const { return e.sign * timeSense(e.a) * timeSense(e.b); }

private:
    const fabric::BondingPoint& point(fabric::PointIndex p) const {
        return m_fabric.points[static_cast<std::size_t>(p)];
    }
    bool crossesBack(fabric::PointIndex p, fabric::PointIndex foot) const;
    int timeSense(const CurvePiece& piece) const;
    int senseOf(fabric::PointIndex p, const CurvePiece& piece) const;
    void addFound(const ProjectedCrossing& crossing, std::size_t index);
    void want(fabric::PointIndex over, fabric::PointIndex under, int sign, float place, bool kink);
    void expectLoops();
    void expectCrossings();
    bool isKink(const fabric::Crossing& crossing) const;
    bool isKink(fabric::PointIndex onFloat, fabric::PointIndex onLeg) const;

    const fabric::Fabric& m_fabric;
    const YarnCurves& m_curves;
    std::vector<CrossingEvent> m_events;
};

} // namespace knittsim::geometry
