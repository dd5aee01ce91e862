#include "core/geometry/curve_planner.h"

#include <algorithm>
#include <cmath>

namespace knittsim::geometry {

namespace {

// Offsets in yarn diameters. Chosen so that plain knit of loop length 8.8 d gets the measured shape of a
// relaxed stitch: crossings 0.43 and 0.71 courses above the base line, head at 0.96, sinker at -0.82, belly
// 0.94 wales wide.
constexpr float kClaspHalfHeight = 0.28F; ///< from a bonding point to its lower and upper crossing
constexpr float kClaspHalfWidth = 0.26F;  ///< new loop inside, old loop outside
constexpr float kDepthGain = 1.4F;        ///< makes up for what the spline cuts off between opposite depths
constexpr float kCrossingGain = 1.5F;
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

constexpr double kLeastRoom = 0.32; ///< courses, about a seventeenth of a loop

/// The yarn turns round, at a selvedge or from one bed to the other.
bool isTurn(const Station& a, const Station& b) {
    return a.side == b.side;
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
      m_stations(fabric, m_diameterMm) {}

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
    const std::vector<Station>& stations = m_stations.collect(yarn, m_diameter);
    addTail(stations.front());
    for (std::size_t i = 0; i < stations.size(); ++i) {
        addStation(stations[i]);
        if (i + 1 < stations.size()) {
            connect(stations[i], stations[i + 1]);
        }
    }
    addTail(stations.back());
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
    } else if (a.isCrossing() || b.isCrossing() || m_stations.isFarAcross(a, b)) {
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
    const bool far = m_stations.isFarAcross(a, b) || m_stations.isTall(a, b);
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
    const float rise = acrossGap ? kLevelRise * m_stations.levels()[static_cast<std::size_t>(b.loop)] : 0;
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
    const auto courses = static_cast<float>(m_stations.coursesBetween(a, b));
    return std::min(kWaitMost, kWaitOut * std::max(0.0F, courses - 1));
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
    if (m_stations.isWrap(a, b)) {
        addWrap(a, b);
        return;
    }
    const bool steep = m_stations.isSteep(a, b);
    const bool kink = m_stations.isKink(a, b);
    if ((steep && !a.isCrossing()) || kink) {
        // Up beside the fabric, outside of the yarns that turn there, and then in.
        const float wait = waitOut(a, b);
        addTurnControl(a, a, kTurnOut + wait, kTurnDown);
        if (kink || m_stations.isStraightUp(a, b)) {
            Station below = b;
            below.side = a.side;
            addTurnControl(below, a, kTurnBackOut + wait, kink ? kKinkDown : kTurnBackDown);
        }
        return;
    }
    if (!a.isCrossing()) {
        addReach(a, b, a, a.lower);
    }
    if (m_stations.isFarAcross(a, b)) {
        m_plan.m_arcs.push_back({.control = newControl(a, b),
                                 .from = a.anchor,
                                 .to = b.anchor,
                                 .storedMm = stored(a),
                                 .gain = kFloatGain,
                                 .mostRise = kFloatMost,
                                 .alongSide = -1,
                                 .out = 0.5F * (a.lower + b.lower)});
    }
    if ((steep || (!a.isCrossing() && m_stations.isInside(b, a))) && !b.isCrossing()) {
        addTurnControl(b, a, kTurnOut, kTurnDown);
    } else if (!b.isCrossing()) {
        addReach(b, a, a, b.lower);
    }
}

void CurvePlanner::addReach(const Station& near, const Station& far, const Station& owner, float out) {
    const bool leg = near.loop == far.loop && !far.isCrossing();
    const bool arrives = near.point > far.point && m_stations.isBesideFloat(near, far);
    m_plan.m_reaches.push_back({.control = newControl(owner, near),
                                .near = near.anchor,
                                .far = far.anchor,
                                .reachMm = kReach * m_diameter,
                                .dipMm = leg ? 0 : (arrives ? -kFloatDip : kFloatDip) * m_diameter,
                                .out = kDepthGain * out});
}

} // namespace knittsim::geometry
