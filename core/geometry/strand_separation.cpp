#include "core/geometry/crossing_audit.h"
#include "core/geometry/yarn_curve_builder.h"

#include <algorithm>

namespace knittsim::geometry {

namespace {

constexpr int kFitRounds = 10;
constexpr int kMostRounds = 12;
constexpr int kLengthRounds = 2;
constexpr float kLeastGap = 0.3F;   ///< diameters between centrelines
constexpr float kEnough = 0.9F;     ///< of that
constexpr float kAsStored = 0.005F; ///< of a length, half of what is asked for

} // namespace

int YarnCurveBuilder::makeExact(const fabric::Fabric& fabric, std::span<const float> positions) {
    for (int round = 0; round < kFitRounds; ++round) {
        update(positions);
        m_plan.fitArcs(m_frames, spanLengths(m_curves));
    }
    orderStrands(fabric, positions);
    update(positions);
    DepthFit fit(splines(), m_weights, m_curves.nodes);
    const std::vector<YarnPiece> pieces = yarnPieces(fabric, m_curves);
    for (int round = 0; round < kMostRounds; ++round) {
        // Strands that lie exactly behind each other may cross elsewhere after they have moved.
        const Orders wanted = ordersOf(fabric);
        if (round > 0 && wanted.wrong == 0) {
            return round;
        }
        fit.run(round < kLengthRounds ? pieces : std::vector<YarnPiece>(), wanted.orders, kAsStored);
        m_curves.nodes = fit.nodes();
        measureArc();
    }
    return -1;
}

std::size_t YarnCurveBuilder::orderStrands(const fabric::Fabric& fabric, std::span<const float> positions) {
    update(positions);
    const Orders wanted = ordersOf(fabric);
    DepthFit fit(splines(), m_weights, m_curves.nodes);
    fit.run({}, wanted.orders, kAsStored);
    std::vector<float>& lift = m_plan.lift();
    for (std::size_t c = 0; c < lift.size(); ++c) {
        lift[c] += fit.moved()[c];
    }
    return wanted.wrong;
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
YarnCurveBuilder::Orders YarnCurveBuilder::ordersOf(const fabric::Fabric& fabric) const {
    const std::vector<ProjectedCrossing> crossings = projectCrossings(m_curves);
    const std::vector<std::int8_t> order = auditCrossings(fabric, m_curves, crossings).order;
    Orders wanted;
    wanted.orders.reserve(crossings.size());
    for (std::size_t i = 0; i < crossings.size(); ++i) {
        const ProjectedCrossing& c = crossings[i];
        const float least = kLeastGap * 0.5F * (diameterAt(c.over) + diameterAt(c.under));
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

float YarnCurveBuilder::diameterAt(std::int32_t node) const {
    const machine::CarrierIndex carrier = m_curves.yarns[yarnAt(m_curves, node)].carrier;
    return carrier < m_diameterMm.size() ? static_cast<float>(m_diameterMm[carrier]) : 0.3F;
}

} // namespace knittsim::geometry
