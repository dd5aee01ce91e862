#include "core/geometry/curve_plan.h"

#include "core/geometry/curve_planner.h"

#include <algorithm>
#include <cmath>

namespace knittsim::geometry {

namespace {

constexpr float kWidestClasp = 0.30F;  ///< in chords
constexpr float kHighestClasp = 0.20F; ///< in rises
constexpr float kFitRate = 0.4F;       ///< smaller is slower and safer
constexpr float kLeastSquare = 1e-6F;  ///< mm^2
constexpr float kLongestReach = 0.33F; ///< of the way

std::size_t at(fabric::EntryIndex entry) {
    return static_cast<std::size_t>(entry);
}

void put(std::vector<ControlValue>& controls, std::int32_t control, const Vec3f& place, float height,
         const Vec3f& normal) {
    controls[static_cast<std::size_t>(control)] = {place.x(),  place.y(),  place.z(),  height,
                                                   normal.x(), normal.y(), normal.z(), 0};
}

float limit(float value, float most) {
    return std::clamp(value, -most, most);
}

} // namespace

CurvePlan::CurvePlan(const fabric::Fabric& fabric, std::span<const double> diameterMm) {
    CurvePlanner(fabric, diameterMm, *this).run();
    m_lift.assign(m_pointOfControl.size(), 0);
}

Vec3f CurvePlan::placeOf(const FrameField& frames, const Anchor& anchor) {
    const std::size_t e = at(anchor.entry);
    const Vec3f& along = frames.along()[e];
    const Vec3f place = frames.position()[e] + anchor.acrossMm * frames.across()[e];
    if (anchor.beside < 0) {
        return place - anchor.drop * frames.rise()[e] * along;
    }
    const Vec3f way = frames.position()[at(anchor.beside)] - frames.position()[e];
    return place + (way.dot(along) - anchor.drop * frames.rise()[at(anchor.beside)]) * along;
}

void CurvePlan::place(const FrameField& frames, std::vector<ControlValue>& controls) const {
    controls.resize(m_pointOfControl.size());
    placeCorners(frames, controls);
    placeArcs(frames, controls);
    placeReaches(frames, controls);
    for (std::size_t c = 0; c < controls.size(); ++c) {
        if (m_lift[c] != 0) {
            ControlValue& value = controls[c];
            for (std::size_t k = 0; k < 3; ++k) {
                value[k] += m_lift[c] * value[4 + k];
            }
            value[3] += m_lift[c];
        }
    }
    // Mirrored end points make the spline begin and end at its first and last control point.
    for (const YarnRange& yarn : m_yarns) {
        const auto first = static_cast<std::size_t>(yarn.first);
        const std::size_t end = first + static_cast<std::size_t>(yarn.count);
        for (std::size_t c = 0; c < ControlValue().size(); ++c) {
            controls[first - 1][c] = 2 * controls[first][c] - controls[first + 1][c];
            controls[end][c] = 2 * controls[end - 1][c] - controls[end - 2][c];
        }
    }
}

void CurvePlan::placeCorners(const FrameField& frames, std::vector<ControlValue>& controls) const {
    for (const Corner& corner : m_corners) {
        const std::size_t e = at(corner.anchor.entry);
        const Vec3f& normal = frames.normal()[e];
        const float across = limit(corner.across, kWidestClasp * frames.chord()[e]);
        const float along = limit(corner.along, kHighestClasp * frames.rise()[e]);
        const Vec3f place = placeOf(frames, corner.anchor) + across * frames.across()[e] +
                            along * frames.along()[e] + corner.out * normal;
        put(controls, corner.control, place, frames.relief()[e] + corner.out, normal);
    }
}

/// How much longer the yarn of an arc is than its chord, mm across.
float CurvePlan::slack(const FrameField& frames, const Arc& arc) {
    const float distance2 = (placeOf(frames, arc.to) - placeOf(frames, arc.from)).squaredNorm();
    return std::sqrt(std::max(0.0F, arc.storedMm * arc.storedMm - distance2));
}

float CurvePlan::amplitude(const FrameField& frames, const Arc& arc, float slackMm) {
    const float rise = 0.5F * (frames.rise()[at(arc.from.entry)] + frames.rise()[at(arc.to.entry)]);
    return std::clamp(arc.gain * slackMm, arc.leastMm, std::max(arc.leastMm, arc.mostRise * rise));
}

void CurvePlan::fitArcs(const FrameField& frames, std::span<const double> lengthMm) {
    for (Arc& arc : m_arcs) {
        const auto point = static_cast<std::size_t>(m_pointOfControl[static_cast<std::size_t>(arc.control)]);
        const float slackMm = slack(frames, arc);
        arc.mostRise = std::max(arc.mostRise, arc.mostFitted);
        const auto length = static_cast<float>(lengthMm[point]);
        if (arc.gain > 0 && slackMm > 0 && length > 0) {
            // The curve gets longer with about the square of the amplitude.
            const float now = amplitude(frames, arc, slackMm);
            const float missing = arc.storedMm * arc.storedMm - length * length;
            arc.gain = std::sqrt(std::max(kLeastSquare, now * now + kFitRate * missing)) / slackMm;
        }
    }
    for (Reach& reach : m_reaches) {
        if (reach.storedMm > 0) {
            const auto point =
                static_cast<std::size_t>(m_pointOfControl[static_cast<std::size_t>(reach.control)]);
            const float ratio = reach.storedMm / static_cast<float>(lengthMm[point]);
            reach.tightness = std::clamp(reach.tightness * ratio, reach.tightest, 1.0F);
        }
    }
}

void CurvePlan::drawIn() {
    for (Arc& arc : m_arcs) {
        arc.gain = 0;
    }
    for (Reach& reach : m_reaches) {
        reach.tightness = reach.storedMm > 0 ? reach.tightest : reach.tightness;
    }
}

void CurvePlan::placeArcs(const FrameField& frames, std::vector<ControlValue>& controls) const {
    for (const Arc& arc : m_arcs) {
        const std::size_t a = at(arc.from.entry);
        const std::size_t b = at(arc.to.entry);
        const Vec3f from = placeOf(frames, arc.from);
        const Vec3f to = placeOf(frames, arc.to);
        const float out = amplitude(frames, arc, slack(frames, arc));
        const float s = arc.share;
        const auto blend = [&](const std::vector<Vec3f>& field) -> Vec3f {
            return (1 - s) * field[a] + s * field[b];
        };
        const Vec3f normal = blend(frames.normal());
        const Vec3f side = arc.acrossSide * blend(frames.across()) + arc.alongSide * blend(frames.along());
        const float relief = (1 - s) * frames.relief()[a] + s * frames.relief()[b];
        put(controls, arc.control, (1 - s) * from + s * to + out * side + arc.out * normal, relief + arc.out,
            normal);
    }
}

void CurvePlan::placeReaches(const FrameField& frames, std::vector<ControlValue>& controls) const {
    for (const Reach& reach : m_reaches) {
        const std::size_t e = at(reach.near.entry);
        const Vec3f from = placeOf(frames, reach.near);
        const Vec3f way = placeOf(frames, reach.far) - from;
        const float length = way.norm();
        const float t = length > 0 ? std::min(kLongestReach, reach.reachMm / length) : 0;
        const Vec3f& normal = frames.normal()[e];
        const Vec3f place = from + t * way + reach.tightness * reach.across * frames.across()[e] -
                            reach.tightness * reach.dipMm * frames.along()[e] + reach.out * normal;
        put(controls, reach.control, place, frames.relief()[e] + reach.out, normal);
    }
}

} // namespace knittsim::geometry
