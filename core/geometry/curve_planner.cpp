#include "core/geometry/curve_planner.h"

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
constexpr float kTailAcross = 1.5F;
constexpr float kTailDown = 0.5F;
constexpr float kReach = 1.6F;
constexpr float kTurnOut = 0.7F;
constexpr float kTurnDown = 0.8F;
constexpr float kFloatDip = 0.5F;

// Slack yarn: how far an arc stands out, as a share of the root of length^2 - chord^2, and its limit in
// rises.
constexpr float kHeadGain = 0.38F;
constexpr float kHeadMost = 0.55F;
constexpr float kBellyGain = 0.30F;
constexpr float kBellyMost = 0.10F;
constexpr float kFloatGain = 0.25F;
constexpr float kFloatMost = 0.4F;
constexpr float kOpenSinkerMost = 0.8F; ///< between loops without feet
constexpr float kArcLeast = 0.35F;      ///< diameters

constexpr double kFarPitches = 1.2; ///< corners farther apart across are joined by a float or a long leg

} // namespace

CurvePlanner::CurvePlanner(const fabric::Fabric& fabric, std::span<const double> diameterMm, CurvePlan& plan)
    : m_fabric(fabric), m_diameterMm(diameterMm), m_plan(plan), m_depths(orderStrands(fabric, diameterMm)) {}

void CurvePlanner::run() {
    m_plan.m_pointOfControl.reserve(m_fabric.points.size() * 3);
    m_plan.m_corners.reserve(m_fabric.points.size() * 2);
    m_plan.m_arcs.reserve(m_fabric.points.size());
    for (const fabric::Yarn& yarn : m_fabric.yarns) {
        if (yarn.count > 0) {
            addYarn(yarn);
        }
    }
}

/// Yarn that runs upwards through its loop: on the way to the head arc.
bool CurvePlanner::isRising(PointIndex p) const {
    const fabric::Loop& loop = m_fabric.loops[static_cast<std::size_t>(point(p).loop)];
    return p <= std::min(loop.headLeft, loop.headRight);
}

bool CurvePlanner::isFarAcross(PointIndex p, PointIndex q) const {
    const Vec3& a = m_fabric.machinePositions[static_cast<std::size_t>(point(p).entry)];
    const Vec3& b = m_fabric.machinePositions[static_cast<std::size_t>(point(q).entry)];
    return std::abs(a.x() - b.x()) > kFarPitches * m_fabric.pitchMm;
}

/// The yarn goes round the selvedge to the next course.
bool CurvePlanner::isTurn(PointIndex p, PointIndex q) const {
    return point(p).side == point(q).side &&
           m_fabric.loops[static_cast<std::size_t>(point(p).loop)].course !=
               m_fabric.loops[static_cast<std::size_t>(point(q).loop)].course;
}

std::int32_t CurvePlanner::newControl(PointIndex p) {
    m_plan.m_pointOfControl.push_back(p);
    return static_cast<std::int32_t>(m_plan.m_pointOfControl.size()) - 1;
}

void CurvePlanner::addYarn(const fabric::Yarn& yarn) {
    m_diameter = yarn.carrier < m_diameterMm.size() ? static_cast<float>(m_diameterMm[yarn.carrier]) : 0.3F;
    newControl(-1);
    CurvePlan::YarnRange range{.first = static_cast<std::int32_t>(m_plan.m_pointOfControl.size()),
                               .carrier = yarn.carrier};
    const PointIndex last = yarn.first + yarn.count - 1;
    addTail(yarn.first);
    for (PointIndex p = yarn.first; p <= last; ++p) {
        addPoint(p);
        if (p < last) {
            connect(p, p + 1);
        }
    }
    addTail(last);
    range.count = static_cast<std::int32_t>(m_plan.m_pointOfControl.size()) - range.first;
    newControl(-1);
    m_plan.m_yarns.push_back(range);
}

void CurvePlanner::addTail(PointIndex p) {
    m_plan.m_reaches.push_back({.control = newControl(p),
                                .near = point(p).entry,
                                .far = point(p).entry,
                                .dipMm = kTailDown * m_diameter,
                                .across = sideSign(p) * kTailAcross * m_diameter,
                                .out = kDepthGain * lower(p)});
}

void CurvePlanner::addPoint(PointIndex p) {
    if (point(p).role == Role::Crossing) {
        m_plan.m_corners.push_back(
            {.control = newControl(p), .entry = point(p).entry, .out = kCrossingGain * lower(p)});
        return;
    }
    const bool rising = isRising(p);
    addCorner(p, !rising);
    addCorner(p, rising);
}

void CurvePlanner::addCorner(PointIndex p, bool atUpper) {
    const float outside = point(p).role == Role::Head ? 1.0F : -1.0F;
    m_plan.m_corners.push_back({.control = newControl(p),
                                .entry = point(p).entry,
                                .across = outside * sideSign(p) * kClaspHalfWidth * m_diameter,
                                .along = (atUpper ? 1.0F : -1.0F) * kClaspHalfHeight * m_diameter,
                                .out = kDepthGain * (atUpper ? upper(p) : lower(p))});
}

/// Crossings before the first corner of their loop lie on the float or sinker that leads to it.
bool CurvePlanner::isOnLeg(PointIndex p) const {
    const fabric::Loop& loop = m_fabric.loops[static_cast<std::size_t>(point(p).loop)];
    for (const PointIndex corner : loop.corners()) {
        if (corner >= 0 && corner < p) {
            return true;
        }
    }
    return point(p).role != Role::Crossing;
}

void CurvePlanner::connect(PointIndex p, PointIndex q) {
    const bool crossing = point(p).role == Role::Crossing || point(q).role == Role::Crossing;
    if (point(p).loop == point(q).loop && isOnLeg(p)) {
        if (point(p).role == Role::Head && point(q).role == Role::Head) {
            addHeadArc(p, q);
        } else if (!crossing) {
            addLeg(p, q);
        }
    } else if (crossing || isFarAcross(p, q)) {
        addFloat(p, q);
    } else if (isTurn(p, q)) {
        addTurn(p, q);
    } else {
        addSinker(p, q);
    }
}

void CurvePlanner::addHeadArc(PointIndex p, PointIndex q) {
    m_plan.m_arcs.push_back({.control = newControl(p),
                             .from = point(p).entry,
                             .to = point(q).entry,
                             .storedMm = stored(p),
                             .gain = kHeadGain,
                             .leastMm = kArcLeast * m_diameter,
                             .mostRise = kHeadMost,
                             .alongSide = 1,
                             .out = 0.5F * kDepthGain * (upper(p) + upper(q))});
}

void CurvePlanner::addLeg(PointIndex p, PointIndex q) {
    const float depth = 0.5F * (isRising(p) ? upper(p) + lower(q) : lower(p) + upper(q));
    const bool far = isFarAcross(p, q);
    if (far) {
        addReach(p, q, p, isRising(p) ? upper(p) : lower(p));
    }
    m_plan.m_arcs.push_back({.control = newControl(p),
                             .from = point(p).entry,
                             .to = point(q).entry,
                             .storedMm = stored(p),
                             .gain = kBellyGain,
                             .mostRise = kBellyMost,
                             .acrossSide = sideSign(p),
                             .out = kDepthGain * depth});
    if (far) {
        addReach(q, p, p, isRising(p) ? lower(q) : upper(q));
    }
}

void CurvePlanner::addSinker(PointIndex p, PointIndex q) {
    const bool open = point(p).role == Role::Head && point(q).role == Role::Head;
    // The long yarn between loops without feet needs a broad bottom.
    const int parts = open ? 2 : 1;
    for (int i = 0; i < parts; ++i) {
        m_plan.m_arcs.push_back({.control = newControl(p),
                                 .from = point(p).entry,
                                 .to = point(q).entry,
                                 .share = open ? 0.3F + 0.4F * static_cast<float>(i) : 0.5F,
                                 .storedMm = stored(p),
                                 .gain = kHeadGain,
                                 .leastMm = kArcLeast * m_diameter,
                                 .mostRise = open ? kOpenSinkerMost : kHeadMost,
                                 .alongSide = -1,
                                 .out = 0.5F * kDepthGain * (lower(p) + lower(q))});
    }
}

void CurvePlanner::addTurn(PointIndex p, PointIndex q) {
    for (const PointIndex near : {p, q}) {
        m_plan.m_reaches.push_back({.control = newControl(p),
                                    .near = point(near).entry,
                                    .far = point(near).entry,
                                    .dipMm = kTurnDown * m_diameter,
                                    .across = sideSign(near) * kTurnOut * m_diameter,
                                    .out = kDepthGain * lower(near)});
    }
}

void CurvePlanner::addFloat(PointIndex p, PointIndex q) {
    if (point(p).role != Role::Crossing) {
        addReach(p, q, p, lower(p));
    }
    if (isFarAcross(p, q)) {
        m_plan.m_arcs.push_back({.control = newControl(p),
                                 .from = point(p).entry,
                                 .to = point(q).entry,
                                 .storedMm = stored(p),
                                 .gain = kFloatGain,
                                 .mostRise = kFloatMost,
                                 .alongSide = -1,
                                 .out = 0.5F * (lower(p) + lower(q))});
    }
    if (point(q).role != Role::Crossing) {
        addReach(q, p, p, lower(q));
    }
}

void CurvePlanner::addReach(PointIndex near, PointIndex far, PointIndex owner, float out) {
    const bool leg = point(near).loop == point(far).loop && point(far).role != Role::Crossing;
    m_plan.m_reaches.push_back({.control = newControl(owner),
                                .near = point(near).entry,
                                .far = point(far).entry,
                                .reachMm = kReach * m_diameter,
                                .dipMm = leg ? 0 : kFloatDip * m_diameter,
                                .out = kDepthGain * out});
}

} // namespace knittsim::geometry
