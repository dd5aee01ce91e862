#include "core/geometry/curve_planner.h"

#include "core/fabric/pass_levels.h"

#include <algorithm>
#include <cmath>

namespace knittsim::geometry {

using fabric::PointIndex;
using fabric::Role;

namespace {

// Offsets in yarn diameters. Chosen so that plain knit of loop length 8.8 d gets the measured shape of a
// relaxed stitch: crossings 0.43 and 0.71 courses above the base line, head at 0.96, sinker at -0.82, belly
// 0.94 wales wide.
constexpr float kClaspHalfHeight = 0.28F; ///< from a bonding point to its lower and upper crossing
constexpr float kClaspHalfWidth = 0.26F;  ///< new loop inside, old loop outside
constexpr float kDepthGain = 1.4F;        ///< makes up for what the spline cuts off between opposite depths
constexpr float kCrossingGain = 1.5F;
constexpr float kShortestLeg = 0.5F; ///< courses
constexpr float kTailAcross = 0.55F;
constexpr float kTailDown = 1.0F;
constexpr float kReach = 1.6F;
constexpr float kLevelRise = 4;
constexpr float kTurnOut = 0.9F;
constexpr float kTurnDown = 0.8F;
constexpr float kTurnBackOut = 1.15F; ///< round the leg that the yarn is drawn through next
constexpr float kTurnBackDown = 0.8F;
constexpr float kTightestTurn = 0.85F; ///< drawn in more it would miss the legs beside it
constexpr float kKinkDown = 0.2F;
constexpr float kWaitOut = 0.15F; ///< for every course more
constexpr float kWaitMost = 1.2F;
constexpr float kFloatDip = 0.5F;

// Slack yarn: how far an arc stands out, as a share of the root of length^2 - chord^2, and its limit in
// rises.
constexpr float kHeadGain = 0.38F;
constexpr float kHeadMost = 0.66F;
constexpr float kHeadMostFitted = 0.95F; ///< where it is to be as long as its yarn
constexpr float kGapSinkerMost = 0.3F;   ///< from bed to bed
constexpr float kBellyGain = 0.30F;
constexpr float kBellyMost = 0.25F;
constexpr float kFloatGain = 0.25F;
constexpr float kFloatMost = 0.4F;
constexpr float kArcLeast = 0.35F; ///< diameters

constexpr double kSteepCourses = 0.75; ///< a float that rises by more runs up the selvedge
constexpr double kBesideEdge = 0.1;    ///< pitches
constexpr double kLeastRoom = 0.32;    ///< courses, about a seventeenth of a loop
constexpr double kTallCourses = 10;
constexpr double kFarPitches = 1.2; ///< corners farther apart across are joined by a float or a long leg

float sideSign(fabric::Side side) {
    return side == fabric::Side::Right ? 1.0F : -1.0F;
}

} // namespace

/// Thin yarn is laid as if it were thicker: strands that pass each other have to differ by something that
/// counts beside the loops.
std::vector<double> CurvePlanner::roomFor(const fabric::Fabric& fabric, std::span<const double> diameterMm) {
    std::vector<double> room(diameterMm.begin(), diameterMm.end());
    for (double& d : room) {
        d = std::max(d, kLeastRoom * fabric.courseMm);
    }
    return room;
}

CurvePlanner::CurvePlanner(const fabric::Fabric& fabric, std::span<const double> diameterMm, CurvePlan& plan)
    : m_fabric(fabric), m_diameterMm(roomFor(fabric, diameterMm)), m_plan(plan),
      m_depths(orderStrands(fabric, m_diameterMm)), m_levels(fabric::passLevels(fabric)),
      m_wales(fabric::walePlaces(fabric).made) {}

void CurvePlanner::run() {
    m_plan.m_pointOfControl.reserve(m_fabric.points.size() * 3);
    m_plan.m_pieceOfControl.reserve(m_fabric.points.size() * 3);
    m_plan.m_corners.reserve(m_fabric.points.size() * 2);
    m_plan.m_arcs.reserve(m_fabric.points.size());
    for (const fabric::Yarn& yarn : m_fabric.yarns) {
        if (yarn.count > 0) {
            addYarn(yarn);
        }
    }
}

CurvePlanner::Station CurvePlanner::stationAt(PointIndex p) const {
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
fabric::EntryIndex CurvePlanner::footBeside(machine::LoopIndex of, bool before) const {
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
CurvePlanner::Station CurvePlanner::baseOf(const Station& onLeg, PointIndex owner) const {
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

void CurvePlanner::collectStations(const fabric::Yarn& yarn) {
    m_stations.clear();
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
}

bool CurvePlanner::isFarAcross(const Station& a, const Station& b) const {
    const Vec3& from = placeOf(a);
    const Vec3& to = placeOf(b);
    return std::abs(from.x() - to.x()) > kFarPitches * m_fabric.pitchMm;
}

/// The yarn runs up along the fabric rather than across.
bool CurvePlanner::isSteep(const Station& a, const Station& b) const {
    const Vec3& from = placeOf(a);
    const Vec3& to = placeOf(b);
    const double across = std::abs(from.x() - to.x());
    const double along = std::abs(from.y() - to.y());
    return across < kBesideEdge * m_fabric.pitchMm ||
           along > std::max(across, kSteepCourses * m_fabric.courseMm);
}

/// The leg of a loop that was held for many courses.
bool CurvePlanner::isTall(const Station& a, const Station& b) const {
    return std::abs(placeOf(a).y() - placeOf(b).y()) > kTallCourses * m_fabric.courseMm;
}

/// The yarn turns round, at a selvedge or from one bed to the other.
bool CurvePlanner::isTurn(const Station& a, const Station& b) {
    return a.side == b.side;
}

/// A yarn between the two has to go round the leg of the first one.
bool CurvePlanner::isInside(const Station& leg, const Station& from) const {
    const double outward = static_cast<double>(sideSign(leg.side)) * (placeOf(from).x() - placeOf(leg).x());
    return outward < -kBesideEdge * m_fabric.pitchMm;
}

/// A float that turns back behind the leg that it comes from.
bool CurvePlanner::isKink(const Station& a, const Station& b) const {
    if (!b.isCrossing() || a.isCrossing()) {
        return false;
    }
    const auto leg = a.side == fabric::Side::Left ? fabric::Piece::LeftLeg : fabric::Piece::RightLeg;
    return other(b).loop == a.loop && other(b).piece == leg;
}

/// A float that passes a leg, turns round it and comes back on its other side.
bool CurvePlanner::isWrap(const Station& a, const Station& b) const {
    if (a.kind != Station::Kind::OnFloat || b.kind != Station::Kind::OnFloat) {
        return false;
    }
    const fabric::BondingPoint& first = other(a);
    const fabric::BondingPoint& second = other(b);
    return first.loop == second.loop && first.piece == second.piece &&
           point(a.point).front != point(b.point).front;
}

/// The point of the other strand at a crossing.
const fabric::BondingPoint& CurvePlanner::other(const Station& at) const {
    const fabric::Crossing& crossing = m_fabric.crossings[static_cast<std::size_t>(point(at.point).crossing)];
    return point(crossing.over == at.point ? crossing.under : crossing.over);
}

std::int32_t CurvePlanner::newControl(const Station& owner, const Station& piece) {
    m_plan.m_pointOfControl.push_back(owner.point);
    m_plan.m_pieceOfControl.push_back(piece.self);
    return static_cast<std::int32_t>(m_plan.m_pointOfControl.size()) - 1;
}

/// A place beyond the end of a yarn.
void CurvePlanner::addEnd() {
    m_plan.m_pointOfControl.push_back(-1);
    m_plan.m_pieceOfControl.push_back(-1);
}

void CurvePlanner::addYarn(const fabric::Yarn& yarn) {
    m_diameter = yarn.carrier < m_diameterMm.size() ? static_cast<float>(m_diameterMm[yarn.carrier]) : 0.3F;
    addEnd();
    CurvePlan::YarnRange range{.first = static_cast<std::int32_t>(m_plan.m_pointOfControl.size()),
                               .carrier = yarn.carrier};
    collectStations(yarn);
    addTail(m_stations.front());
    for (std::size_t i = 0; i < m_stations.size(); ++i) {
        addStation(m_stations[i]);
        if (i + 1 < m_stations.size()) {
            connect(m_stations[i], m_stations[i + 1]);
        }
    }
    addTail(m_stations.back());
    range.count = static_cast<std::int32_t>(m_plan.m_pointOfControl.size()) - range.first;
    addEnd();
    m_plan.m_yarns.push_back(range);
}

void CurvePlanner::addTail(const Station& at) {
    m_plan.m_reaches.push_back({.control = newControl(at, at),
                                .near = at.anchor,
                                .far = at.anchor,
                                .dipMm = kTailDown * m_diameter,
                                .across = sideSign(at.side) * kTailAcross * m_diameter,
                                .out = kDepthGain * at.lower});
}

void CurvePlanner::addStation(const Station& at) {
    if (at.isCrossing()) {
        m_plan.m_corners.push_back(
            {.control = newControl(at, at), .anchor = at.anchor, .out = kCrossingGain * at.lower});
        return;
    }
    if (at.kind == Station::Kind::Base) {
        m_plan.m_corners.push_back({.control = newControl(at, at),
                                    .anchor = at.anchor,
                                    .across = sideSign(at.side) * kClaspHalfWidth * m_diameter,
                                    .out = at.lower});
        return;
    }
    addCorner(at, !at.incoming);
    addCorner(at, at.incoming);
}

void CurvePlanner::addCorner(const Station& at, bool atUpper) {
    const float outside = at.kind == Station::Kind::Head ? 1.0F : -1.0F;
    m_plan.m_corners.push_back({.control = newControl(at, at),
                                .anchor = at.anchor,
                                .across = outside * sideSign(at.side) * kClaspHalfWidth * m_diameter,
                                .along = (atUpper ? 1.0F : -1.0F) * kClaspHalfHeight * m_diameter,
                                .out = kDepthGain * (atUpper ? at.upper : at.lower)});
}

void CurvePlanner::connect(const Station& a, const Station& b) {
    if (a.kind == Station::Kind::Head && b.kind == Station::Kind::Head && a.loop == b.loop) {
        addHeadArc(a, b);
    } else if (a.loop == b.loop && a.kind != Station::Kind::OnFloat && b.kind != Station::Kind::OnFloat) {
        if (!a.isCrossing() && !b.isCrossing()) {
            addLeg(a, b);
        }
    } else if (a.isCrossing() || b.isCrossing() || isFarAcross(a, b)) {
        addFloat(a, b);
    } else if (isTurn(a, b)) {
        addTurn(a, b);
    } else {
        addSinker(a, b);
    }
}

void CurvePlanner::addHeadArc(const Station& a, const Station& b) {
    m_plan.m_arcs.push_back({.control = newControl(a, b),
                             .from = a.anchor,
                             .to = b.anchor,
                             .storedMm = stored(a),
                             .gain = kHeadGain,
                             .leastMm = kArcLeast * m_diameter,
                             .mostRise = kHeadMost,
                             .mostFitted = kHeadMostFitted,
                             .alongSide = 1,
                             .out = 0.5F * kDepthGain * (a.upper + b.upper)});
}

void CurvePlanner::addLeg(const Station& a, const Station& b) {
    const float nearA = a.incoming ? a.upper : a.lower;
    const float nearB = b.incoming ? b.lower : b.upper;
    const bool far = isFarAcross(a, b) || isTall(a, b);
    if (far) {
        addReach(a, b, a, nearA);
    }
    const bool foot = a.kind == Station::Kind::Foot || b.kind == Station::Kind::Foot;
    m_plan.m_arcs.push_back({.control = newControl(a, b),
                             .from = a.anchor,
                             .to = b.anchor,
                             .storedMm = stored(a),
                             .gain = foot ? kBellyGain : 0,
                             .mostRise = kBellyMost,
                             .acrossSide = sideSign(a.side),
                             .out = 0.5F * kDepthGain * (nearA + nearB)});
    if (far) {
        addReach(b, a, a, nearB);
    }
}

void CurvePlanner::addSinker(const Station& a, const Station& b) {
    // Where several passes of a course run from bed to bed, the later yarns lie above the earlier ones.
    const bool acrossGap = pullSign(m_fabric, a.loop) != pullSign(m_fabric, b.loop);
    const float rise = acrossGap ? kLevelRise * m_levels[static_cast<std::size_t>(b.loop)] : 0;
    m_plan.m_arcs.push_back({.control = newControl(a, b),
                             .from = a.anchor,
                             .to = b.anchor,
                             .storedMm = stored(a),
                             .gain = kHeadGain,
                             .leastMm = kArcLeast * m_diameter,
                             .mostRise = acrossGap ? kGapSinkerMost : kHeadMost,
                             .mostFitted = acrossGap ? kGapSinkerMost : kHeadMostFitted,
                             .alongSide = rise - 1,
                             .out = 0.5F * kDepthGain * (a.lower + b.lower)});
}

void CurvePlanner::addTurn(const Station& a, const Station& b) {
    const float wait = waitOut(a, b);
    addTurnControl(a, a, kTurnOut + wait, kTurnDown);
    fitTurn(a);
    addTurnControl(b, a, kTurnBackOut + wait, kTurnBackDown);
    fitTurn(a);
}

void CurvePlanner::fitTurn(const Station& owner) {
    m_plan.m_reaches.back().storedMm = stored(owner);
    m_plan.m_reaches.back().tightest = kTightestTurn;
}

/// A yarn that waits for some courses runs outside of those that turn meanwhile, diameters.
float CurvePlanner::waitOut(const Station& a, const Station& b) const {
    const double courses = std::abs(placeOf(a).y() - placeOf(b).y()) / m_fabric.courseMm;
    return std::min(kWaitMost, kWaitOut * std::max(0.0F, static_cast<float>(courses) - 1));
}

void CurvePlanner::addTurnControl(const Station& near, const Station& owner, float across, float down) {
    m_plan.m_reaches.push_back({.control = newControl(owner, near),
                                .near = near.anchor,
                                .far = near.anchor,
                                .dipMm = down * m_diameter,
                                .across = sideSign(near.side) * across * m_diameter,
                                .out = kDepthGain * near.lower});
}

/// Beyond the leg that both stations lie on.
void CurvePlanner::addWrap(const Station& a, const Station& b) {
    const fabric::Crossing& crossing = m_fabric.crossings[static_cast<std::size_t>(point(a.point).crossing)];
    const bool rightward = (crossing.sign > 0) == (crossing.over == a.point);
    for (Station beyond : {a, b}) {
        beyond.side = rightward ? fabric::Side::Right : fabric::Side::Left;
        addTurnControl(beyond, a, kTurnOut, 0);
    }
}

void CurvePlanner::addFloat(const Station& a, const Station& b) {
    if (isWrap(a, b)) {
        addWrap(a, b);
        return;
    }
    const bool steep = isSteep(a, b);
    const bool kink = isKink(a, b);
    if ((steep && !a.isCrossing()) || kink) {
        // Up beside the fabric, outside of the yarns that turn there, and then in.
        const float wait = waitOut(a, b);
        addTurnControl(a, a, kTurnOut + wait, kTurnDown);
        const double outward = static_cast<double>(sideSign(a.side)) * (placeOf(b).x() - placeOf(a).x());
        if (kink || outward < kBesideEdge * m_fabric.pitchMm) {
            Station below = b;
            below.side = a.side;
            addTurnControl(below, a, kTurnBackOut + wait, kink ? kKinkDown : kTurnBackDown);
        }
        return;
    }
    if (!a.isCrossing()) {
        addReach(a, b, a, a.lower);
    }
    if (isFarAcross(a, b)) {
        m_plan.m_arcs.push_back({.control = newControl(a, b),
                                 .from = a.anchor,
                                 .to = b.anchor,
                                 .storedMm = stored(a),
                                 .gain = kFloatGain,
                                 .mostRise = kFloatMost,
                                 .alongSide = -1,
                                 .out = 0.5F * (a.lower + b.lower)});
    }
    if ((steep || (!a.isCrossing() && isInside(b, a))) && !b.isCrossing()) {
        addTurnControl(b, a, kTurnOut, kTurnDown);
    } else if (!b.isCrossing()) {
        addReach(b, a, a, b.lower);
    }
}

/// Next to the foot another yarn passes.
bool CurvePlanner::isBesideFloat(const Station& foot, const Station& crossing) const {
    if (crossing.kind != Station::Kind::OnFloat) {
        return false;
    }
    return other(crossing).piece == fabric::Piece::Float &&
           std::abs(placeOf(foot).x() - placeOf(crossing).x()) < 0.5 * m_fabric.pitchMm;
}

void CurvePlanner::addReach(const Station& near, const Station& far, const Station& owner, float out) {
    const bool leg = near.loop == far.loop && !far.isCrossing();
    const bool arrives = near.point > far.point && isBesideFloat(near, far);
    m_plan.m_reaches.push_back({.control = newControl(owner, near),
                                .near = near.anchor,
                                .far = far.anchor,
                                .reachMm = kReach * m_diameter,
                                .dipMm = leg ? 0 : (arrives ? -kFloatDip : kFloatDip) * m_diameter,
                                .out = kDepthGain * out});
}

} // namespace knittsim::geometry
