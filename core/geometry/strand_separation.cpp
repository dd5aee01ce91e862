#include "core/geometry/crossing_audit.h"
#include "core/geometry/spline.h"
#include "core/geometry/yarn_curve_builder.h"

#include <algorithm>
#include <limits>

namespace knittsim::geometry {

namespace {

constexpr int kFitRounds = 10;
constexpr int kMostRounds = 24;
constexpr int kIdleRounds = 3;    ///< without fewer wrong crossings than ever before
constexpr float kLeastGap = 0.3F; ///< diameters between centrelines

} // namespace

int YarnCurveBuilder::makeExact(const fabric::Fabric& fabric, std::span<const float> positions) {
    fitLengths(positions);
    std::size_t fewest = std::numeric_limits<std::size_t>::max();
    int idle = 0;
    for (int round = 0; round < kMostRounds; ++round) {
        const std::size_t wrong = orderStrands(fabric, positions);
        if (wrong == 0) {
            return round;
        }
        idle = wrong < fewest ? 0 : idle + 1;
        fewest = std::min(fewest, wrong);
        if (idle > kIdleRounds) {
            break;
        }
    }
    return -1;
}

std::size_t YarnCurveBuilder::orderStrands(const fabric::Fabric& fabric, std::span<const float> positions) {
    update(positions);
    const std::vector<ProjectedCrossing> crossings = projectCrossings(m_curves);
    return raise(crossings, auditCrossings(fabric, m_curves, crossings).order);
}

void YarnCurveBuilder::fitLengths(std::span<const float> positions) {
    for (int round = 0; round < kFitRounds; ++round) {
        update(positions);
        m_plan.fitArcs(m_frames, spanLengths(m_curves));
    }
}

/// Moves the strands of every crossing that is not as it should be half the missing distance each. Where
/// several crossings pull at one control point it moves by their mean. Returns how many were not.
std::size_t YarnCurveBuilder::raise(const std::vector<ProjectedCrossing>& crossings,
                                    const std::vector<std::int8_t>& order) {
    std::vector<float>& lift = m_plan.lift();
    std::vector<float> move(lift.size(), 0);
    std::vector<float> pulls(lift.size(), 0);
    const auto samples = static_cast<float>(m_weights.size());
    const auto pull = [&](std::int32_t node, float share, float by) {
        const std::size_t control = controlAt(node);
        const std::int32_t within = node - m_nodeOfControl[control];
        const auto weights = splineWeights((static_cast<float>(within) + share) / samples);
        float squares = 0;
        for (const float w : weights) {
            squares += w * w;
        }
        for (std::size_t i = 0; i < weights.size(); ++i) {
            move[control + i - 1] += by * weights[i] / squares * weights[i];
            pulls[control + i - 1] += weights[i];
        }
    };
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < crossings.size(); ++i) {
        const ProjectedCrossing& c = crossings[i];
        const float least = kLeastGap * 0.5F * (diameterAt(c.over) + diameterAt(c.under));
        const float missing = least - static_cast<float>(order[i]) * c.gapMm;
        if (order[i] == 0 || missing <= 0) {
            continue;
        }
        ++wrong;
        const float by = static_cast<float>(order[i]) * 0.5F * (missing + 0.1F * least);
        pull(c.over, c.overShare, by);
        pull(c.under, c.underShare, -by);
    }
    for (std::size_t c = 0; c < lift.size(); ++c) {
        lift[c] += pulls[c] > 0 ? move[c] / pulls[c] : 0;
    }
    return wrong;
}

/// The control point at a node, or the one before it.
std::size_t YarnCurveBuilder::controlAt(std::int32_t node) const {
    const std::size_t yarn = yarnAt(m_curves, node);
    const auto within = static_cast<std::size_t>(node - m_curves.yarns[yarn].first);
    return static_cast<std::size_t>(m_plan.yarns()[yarn].first) + within / m_weights.size();
}

float YarnCurveBuilder::diameterAt(std::int32_t node) const {
    const machine::CarrierIndex carrier = m_curves.yarns[yarnAt(m_curves, node)].carrier;
    return carrier < m_diameterMm.size() ? static_cast<float>(m_diameterMm[carrier]) : 0.3F;
}

} // namespace knittsim::geometry
