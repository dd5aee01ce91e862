#include "core/geometry/crossing_audit.h"
#include "core/geometry/spline.h"
#include "core/geometry/yarn_curve_builder.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace knittsim::geometry {

namespace {

constexpr int kFitRounds = 10;
constexpr int kMostRounds = 24;
constexpr int kIdleRounds = 3; ///< without fewer wrong crossings than ever before
constexpr int kDepthRounds = 12;
constexpr int kLengthRounds = 2;    ///< of these
constexpr float kWantedGap = 0.3F;  ///< diameters between centrelines
constexpr float kLeastGap = 0.5F;   ///< of that, where the yarn is to be as long as stored
constexpr float kEnough = 0.9F;     ///< of that
constexpr float kAsStored = 0.005F; ///< of a length, half of what is asked for

} // namespace

int YarnCurveBuilder::makeExact(const fabric::Fabric& fabric, std::span<const float> positions) {
    for (int round = 0; round < kFitRounds; ++round) {
        update(positions);
        m_plan.fitArcs(m_frames, pieceLengths(fabric));
    }
    std::size_t fewest = std::numeric_limits<std::size_t>::max();
    update(positions);
    Audited audited = audit(fabric);
    for (int round = 0, idle = 0; round < kMostRounds && idle <= kIdleRounds; ++round) {
        const std::size_t wrong = raise(audited);
        if (wrong == 0) {
            break;
        }
        idle = wrong < fewest ? 0 : idle + 1;
        fewest = std::min(fewest, wrong);
        update(positions);
        audited = audit(fabric);
    }
    return fitDepth(fabric, std::move(audited));
}

/// By bonding point: mm of the curve from there to the next one, each as much too long or too short as the
/// whole piece of yarn between feet and heads is: where its crossings lie along it does not matter.
std::vector<double> YarnCurveBuilder::pieceLengths(const fabric::Fabric& fabric) const {
    std::vector<double> lengths = spanLengths(m_curves);
    for (const YarnPiece& piece : yarnPieces(fabric, m_curves)) {
        const auto first = static_cast<std::size_t>(piece.firstNode);
        const auto last = static_cast<std::size_t>(piece.lastNode);
        const double ratio = static_cast<double>((m_curves.arc[last] - m_curves.arc[first]) / piece.storedMm);
        for (auto p = static_cast<std::size_t>(m_curves.point[first]);
             piece.storedMm > 0 && p < static_cast<std::size_t>(m_curves.point[last]); ++p) {
            lengths[p] = ratio * fabric.lengths[p];
        }
    }
    return lengths;
}

/// Only in depth, so that what is in order stays. Strands that lie exactly behind each other may cross
/// elsewhere after they have moved: then it is looked at again.
int YarnCurveBuilder::fitDepth(const fabric::Fabric& fabric, Audited audited) {
    DepthFit fit(splines(), m_weights, m_curves.nodes);
    const std::vector<YarnPiece> pieces = yarnPieces(fabric, m_curves);
    for (int round = 0; round < kDepthRounds; ++round) {
        const Orders wanted = ordersOf(audited);
        if (round > 0 && wanted.wrong == 0) {
            return round;
        }
        fit.run(round < kLengthRounds ? pieces : std::vector<YarnPiece>(), wanted.orders, kAsStored);
        m_curves.nodes = fit.nodes();
        measureArc();
        if (round + 1 < kDepthRounds) {
            audited = audit(fabric);
        }
    }
    return -1;
}

std::size_t YarnCurveBuilder::orderStrands(const fabric::Fabric& fabric, std::span<const float> positions) {
    update(positions);
    return raise(audit(fabric));
}

YarnCurveBuilder::Audited YarnCurveBuilder::audit(const fabric::Fabric& fabric) const {
    std::vector<ProjectedCrossing> crossings = projectCrossings(m_curves);
    std::vector<std::int8_t> order = auditCrossings(fabric, m_curves, crossings).order;
    return {std::move(crossings), std::move(order)};
}

/// Between the centrelines of two strands that cross, mm.
float YarnCurveBuilder::wantedGap(const ProjectedCrossing& crossing) const {
    return kWantedGap * 0.5F * (diameterAt(crossing.over) + diameterAt(crossing.under));
}

/// Moves the strands of every crossing that is not as it should be half the missing distance each. Where
/// several crossings pull at one control point it moves by their mean. Returns how many were not.
std::size_t YarnCurveBuilder::raise(const Audited& audited) {
    const auto& [crossings, order] = audited;
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
        const float least = wantedGap(c);
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

std::vector<DepthFit::Spline> YarnCurveBuilder::splines() const {
    std::vector<DepthFit::Spline> splines;
    for (std::size_t i = 0; i < m_curves.yarns.size(); ++i) {
        const CurvePlan::YarnRange& yarn = m_plan.yarns()[i];
        splines.push_back({yarn.first, yarn.count, m_curves.yarns[i].first});
    }
    return splines;
}

/// What the books ask of every crossing of the curves; one of which they say nothing is to stay as it is.
YarnCurveBuilder::Orders YarnCurveBuilder::ordersOf(const Audited& audited) const {
    const auto& [crossings, order] = audited;
    Orders wanted;
    wanted.orders.reserve(crossings.size());
    for (std::size_t i = 0; i < crossings.size(); ++i) {
        const ProjectedCrossing& c = crossings[i];
        const float least = kLeastGap * wantedGap(c);
        if (order[i] < 0) {
            wanted.orders.push_back({c.under, c.over, c.underShare, c.overShare, least});
            ++wanted.wrong;
        } else {
            const bool known = order[i] > 0;
            wanted.orders.push_back(
                {c.over, c.under, c.overShare, c.underShare, known ? least : std::min(least, c.gapMm)});
            wanted.wrong += known && c.gapMm < kEnough * least ? 1 : 0;
        }
    }
    return wanted;
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
