#include "core/geometry/yarn_stations.h"

#include "core/fabric/pass_levels.h"

#include <algorithm>
#include <cmath>

namespace knittsim::geometry {

using fabric::PointIndex;
using fabric::Role;

namespace {

constexpr float kShortestLeg = 0.5F;   ///< courses
constexpr double kSteepCourses = 0.75; ///< a float that rises by more runs up the selvedge
constexpr double kBesideEdge = 0.1;    ///< pitches
constexpr double kTallCourses = 10;
constexpr double kFarPitches = 1.2; ///< corners farther apart across are joined by a float or a long leg

} // namespace

float sideSign(fabric::Side side) {
    return side == fabric::Side::Right ? 1.0F : -1.0F;
}

YarnStations::YarnStations(const fabric::Fabric& fabric, const std::vector<double>& diameterMm)
    : m_fabric(fabric), m_depths(orderStrands(fabric, diameterMm)), m_levels(fabric::passLevels(fabric)),
      m_wales(fabric::walePlaces(fabric).made) {}

Station YarnStations::stationAt(PointIndex p) const {
    const fabric::BondingPoint& bp = point(p);
    const fabric::Loop& l = loop(bp.loop);
    Station station{.point = p,
                    .self = p,
                    .loop = bp.loop,
                    .side = bp.side,
                    .anchor = {bp.entry, 0},
                    .incoming = p <= std::min(l.headLeft, l.headRight),
                    .lower = m_depths[static_cast<std::size_t>(p)].lower,
                    .upper = m_depths[static_cast<std::size_t>(p)].upper};
    switch (bp.role) {
    case Role::Foot:
        station.kind = Station::Kind::Foot;
        break;
    case Role::Head:
        station.kind = Station::Kind::Head;
        break;
    case Role::Crossing:
        station.kind = bp.piece == fabric::Piece::Float ? Station::Kind::OnFloat : Station::Kind::OnLeg;
        break;
    }
    return station;
}

/// Entry of the nearest foot along the yarn before or after a loop without feet, if it lies in the same
/// course; -1 for none.
fabric::EntryIndex YarnStations::footBeside(machine::LoopIndex of, bool before) const {
    const fabric::Loop& own = loop(of);
    for (const int step : {before ? -1 : 1, before ? 1 : -1}) {
        PointIndex p =
            step < 0 ? std::min(own.headLeft, own.headRight) : std::max(own.headLeft, own.headRight);
        while (p >= m_yarnFirst && p < m_yarnEnd &&
               (point(p).loop == of || point(p).role == Role::Crossing)) {
            p += step;
        }
        if (p >= m_yarnFirst && p < m_yarnEnd && point(p).role == Role::Foot &&
            loop(point(p).loop).course == own.course) {
            return point(p).entry;
        }
    }
    return -1;
}

/// The base of the leg that `onLeg` lies on.
Station YarnStations::baseOf(const Station& onLeg, PointIndex owner) const {
    const fabric::Loop& l = loop(onLeg.loop);
    const PointIndex head =
        onLeg.incoming ? std::min(l.headLeft, l.headRight) : std::max(l.headLeft, l.headRight);
    Station base = stationAt(head);
    base.kind = Station::Kind::Base;
    base.self = onLeg.point;
    base.point = owner;
    const float level = m_levels[static_cast<std::size_t>(onLeg.loop)];
    base.anchor.beside = footBeside(onLeg.loop, onLeg.incoming);
    base.anchor.drop = base.anchor.beside < 0 ? 1 - level : -level;
    if (base.anchor.beside >= 0 && placeOf(base).y() - placeOf(base.anchor.beside).y() <
                                       static_cast<double>(level + kShortestLeg) * m_fabric.courseMm) {
        base.anchor.beside = -1;
        base.anchor.drop = kShortestLeg;
    }
    const fabric::WalePlace& wale = m_wales[static_cast<std::size_t>(onLeg.loop)];
    const double x =
        (wale.centre + static_cast<double>(sideSign(base.side)) * wale.halfWidth) * m_fabric.pitchMm;
    base.anchor.acrossMm = static_cast<float>(x - placeOf(base).x());
    base.lower = base.upper = -0.5F * static_cast<float>(pullSign(m_fabric, onLeg.loop)) * m_diameter;
    return base;
}

const std::vector<Station>& YarnStations::collect(const fabric::Yarn& yarn, float diameterMm) {
    m_stations.clear();
    m_diameter = diameterMm;
    const PointIndex end = yarn.first + yarn.count;
    m_yarnFirst = yarn.first;
    m_yarnEnd = end;
    for (PointIndex p = yarn.first; p < end; ++p) {
        const Station station = stationAt(p);
        const bool footless = loop(station.loop).footLeft < 0 && station.kind != Station::Kind::OnFloat;
        const bool begins = m_stations.empty() || m_stations.back().loop != station.loop ||
                            m_stations.back().kind == Station::Kind::OnFloat;
        if (footless && begins) {
            m_stations.push_back(baseOf(station, std::max(yarn.first, p - 1)));
        }
        m_stations.push_back(station);
        if (footless && (p + 1 == end || point(p + 1).loop != station.loop)) {
            m_stations.push_back(baseOf(station, p));
        }
    }
    return m_stations;
}

double YarnStations::coursesBetween(const Station& a, const Station& b) const {
    return std::abs(placeOf(a).y() - placeOf(b).y()) / m_fabric.courseMm;
}

bool YarnStations::isFarAcross(const Station& a, const Station& b) const {
    const Vec3& from = placeOf(a);
    const Vec3& to = placeOf(b);
    return std::abs(from.x() - to.x()) > kFarPitches * m_fabric.pitchMm;
}

/// The yarn runs up along the fabric rather than across.
bool YarnStations::isSteep(const Station& a, const Station& b) const {
    const Vec3& from = placeOf(a);
    const Vec3& to = placeOf(b);
    const double across = std::abs(from.x() - to.x());
    const double along = std::abs(from.y() - to.y());
    return across < kBesideEdge * m_fabric.pitchMm ||
           along > std::max(across, kSteepCourses * m_fabric.courseMm);
}

/// The leg of a loop that was held for many courses.
bool YarnStations::isTall(const Station& a, const Station& b) const {
    return coursesBetween(a, b) > kTallCourses;
}

/// A yarn between the two has to go round the leg of the first one.
bool YarnStations::isInside(const Station& leg, const Station& from) const {
    return outward(leg, from) < -kBesideEdge * m_fabric.pitchMm;
}

/// `b` lies on the line of the leg of `a` or inside of it.
bool YarnStations::isStraightUp(const Station& a, const Station& b) const {
    return outward(a, b) < kBesideEdge * m_fabric.pitchMm;
}

/// mm across, away from the loop of `leg`.
double YarnStations::outward(const Station& leg, const Station& to) const {
    return static_cast<double>(sideSign(leg.side)) * (placeOf(to).x() - placeOf(leg).x());
}

/// A float that turns back behind the leg that it comes from.
bool YarnStations::isKink(const Station& a, const Station& b) const {
    if (!b.isCrossing() || a.isCrossing()) {
        return false;
    }
    const auto leg = a.side == fabric::Side::Left ? fabric::Piece::LeftLeg : fabric::Piece::RightLeg;
    return other(b).loop == a.loop && other(b).piece == leg;
}

/// A float that passes a leg, turns round it and comes back on its other side.
bool YarnStations::isWrap(const Station& a, const Station& b) const {
    if (a.kind != Station::Kind::OnFloat || b.kind != Station::Kind::OnFloat) {
        return false;
    }
    const fabric::BondingPoint& first = other(a);
    const fabric::BondingPoint& second = other(b);
    return first.loop == second.loop && first.piece == second.piece &&
           point(a.point).front != point(b.point).front;
}

/// The point of the other strand at a crossing.
const fabric::BondingPoint& YarnStations::other(const Station& at) const {
    const fabric::Crossing& crossing = m_fabric.crossings[static_cast<std::size_t>(point(at.point).crossing)];
    return point(crossing.over == at.point ? crossing.under : crossing.over);
}

/// Next to the foot another yarn passes.
bool YarnStations::isBesideFloat(const Station& foot, const Station& crossing) const {
    if (crossing.kind != Station::Kind::OnFloat) {
        return false;
    }
    return other(crossing).piece == fabric::Piece::Float &&
           std::abs(placeOf(foot).x() - placeOf(crossing).x()) < 0.5 * m_fabric.pitchMm;
}

} // namespace knittsim::geometry
