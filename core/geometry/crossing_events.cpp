#include "core/geometry/crossing_events.h"

#include "core/geometry/strand_order.h"

#include <algorithm>
#include <cstdlib>
#include <tuple>
#include <utility>

namespace knittsim::geometry {

using fabric::BondingPoint;
using fabric::Fabric;
using fabric::Piece;
using fabric::PointIndex;
using fabric::Role;

namespace {

void sortByPlace(std::vector<CrossingEvent>& events) {
    std::ranges::stable_sort(events, [](const CrossingEvent& x, const CrossingEvent& y) {
        return std::tie(x.a, x.b, x.place) < std::tie(y.a, y.b, y.place);
    });
}

} // namespace

CrossingEvents::CrossingEvents(const Fabric& fabric, const YarnCurves& curves)
    : m_fabric(fabric), m_curves(curves) {}

std::vector<CrossingEvent> CrossingEvents::wanted() {
    m_events.clear();
    expectLoops();
    expectCrossings();
    sortByPlace(m_events);
    return std::move(m_events);
}

std::vector<CrossingEvent> CrossingEvents::found(const std::vector<ProjectedCrossing>& crossings) {
    m_events.clear();
    for (std::size_t i = 0; i < crossings.size(); ++i) {
        addFound(crossings[i], i);
    }
    sortByPlace(m_events);
    return std::move(m_events);
}

CurvePiece CrossingEvents::pieceOf(PointIndex p) const {
    const BondingPoint& bp = point(p);
    if (bp.role != Role::Crossing) {
        return {bp.loop, bp.side == fabric::Side::Left ? Piece::LeftLeg : Piece::RightLeg};
    }
    if (bp.piece == Piece::Float) {
        for (const PointIndex beside : {p + 1, p - 1}) {
            if (crossesBack(p, beside)) {
                return pieceOf(beside);
            }
        }
    }
    return {bp.loop, bp.piece};
}

/// A float passes a leg just before its loop is drawn through there (or just after): both belong to one
/// piece, on which they cancel if the yarn turned round.
bool CrossingEvents::crossesBack(PointIndex p, PointIndex foot) const {
    if (foot < 0 || foot >= static_cast<PointIndex>(m_fabric.points.size()) ||
        point(foot).role != Role::Foot) {
        return false;
    }
    const fabric::Crossing& crossing = m_fabric.crossings[static_cast<std::size_t>(point(p).crossing)];
    const BondingPoint& other = point(crossing.over == p ? crossing.under : crossing.over);
    const Piece side = point(foot).side == fabric::Side::Left ? Piece::LeftLeg : Piece::RightLeg;
    const auto parents = m_fabric.made.parentsOf(point(foot).loop);
    return other.piece == side && std::ranges::find(parents, other.loop) != parents.end();
}

/// +1 when time runs along the yarn there, -1 when it runs against it.
int CrossingEvents::timeSense(const CurvePiece& piece) const {
    if (piece.piece == Piece::Float) {
        return 1;
    }
    const bool rightward =
        m_fabric.made.loops[static_cast<std::size_t>(piece.loop)].direction == machine::Direction::Right;
    return rightward == (piece.piece == Piece::LeftLeg) ? 1 : -1;
}

/// -1 where a point of a float counts as part of a leg that time runs up against the yarn.
int CrossingEvents::senseOf(PointIndex p, const CurvePiece& piece) const {
    return point(p).piece == Piece::Float && point(p).role == Role::Crossing ? timeSense(piece) : 1;
}

void CrossingEvents::addFound(const ProjectedCrossing& crossing, std::size_t index) {
    const PointIndex overPoint = m_curves.piece[static_cast<std::size_t>(crossing.over)];
    const PointIndex underPoint = m_curves.piece[static_cast<std::size_t>(crossing.under)];
    const CurvePiece over = pieceOf(overPoint);
    const CurvePiece under = pieceOf(underPoint);
    if (over == under) {
        return;
    }
    const int sign = crossing.sign * timeSense(over) * timeSense(under);
    const float onOver =
        static_cast<float>(timeSense(over)) * (static_cast<float>(crossing.over) + crossing.overShare);
    const float onUnder =
        static_cast<float>(timeSense(under)) * (static_cast<float>(crossing.under) + crossing.underShare);
    if (over < under) {
        m_events.push_back({over, under, true, sign, onOver, overPoint, underPoint, crossing.over, index});
    } else {
        m_events.push_back({under, over, false, sign, onUnder, overPoint, underPoint, crossing.under, index});
    }
}

void CrossingEvents::want(PointIndex over, PointIndex under, int sign, float place, bool kink) {
    const CurvePiece a = pieceOf(over);
    const CurvePiece b = pieceOf(under);
    m_events.push_back({std::min(a, b), std::max(a, b), a < b, sign, place, over, under, -1, 0, kink});
}

/// A loop passes behind the legs of the loops that it is drawn through and over their heads, or the other
/// way round on the rear bed.
void CrossingEvents::expectLoops() {
    for (std::size_t i = 0; i < m_fabric.loops.size(); ++i) {
        const auto child = static_cast<machine::LoopIndex>(i);
        if (m_fabric.loops[i].footLeft < 0) {
            continue;
        }
        for (const machine::LoopIndex parent : m_fabric.made.parentsOf(child)) {
            for (const Piece side : {Piece::LeftLeg, Piece::RightLeg}) {
                const bool left = side == Piece::LeftLeg;
                const fabric::Loop& own = m_fabric.loops[i];
                const fabric::Loop& old = m_fabric.loops[static_cast<std::size_t>(parent)];
                const PointIndex self = left ? own.footLeft : own.footRight;
                const PointIndex other = left ? old.headLeft : old.headRight;
                const bool front = pullSign(m_fabric, child) > 0;
                const int sign = front == left ? -1 : 1;
                want(front ? other : self, front ? self : other, sign, 0, false);
                want(front ? self : other, front ? other : self, sign, 1, false);
            }
        }
    }
}

void CrossingEvents::expectCrossings() {
    for (const fabric::Crossing& crossing : m_fabric.crossings) {
        if (crossing.over >= 0 && crossing.under >= 0) {
            // Time runs up a leg, but down from its foot along the float behind it.
            const CurvePiece over = pieceOf(crossing.over);
            const CurvePiece under = pieceOf(crossing.under);
            const int sense = senseOf(crossing.over, over) * senseOf(crossing.under, under);
            want(crossing.over, crossing.under, crossing.sign * sense, -1, isKink(crossing));
        }
    }
}

/// A yarn that turns back behind the leg it has just left makes a kink (first Reidemeister move).
bool CrossingEvents::isKink(const fabric::Crossing& crossing) const {
    return isKink(crossing.over, crossing.under) || isKink(crossing.under, crossing.over);
}
bool CrossingEvents::isKink(PointIndex onFloat, PointIndex onLeg) const {
    if (point(onFloat).piece != Piece::Float || point(onLeg).piece == Piece::Float) {
        return false;
    }
    const auto step = onFloat < onLeg ? 1 : -1;
    for (PointIndex p = onFloat; p != onLeg; p += step) {
        const bool same = pieceOf(p) == pieceOf(onLeg) || (p == onFloat);
        if (!same) {
            return false;
        }
    }
    return true;
}

} // namespace knittsim::geometry
