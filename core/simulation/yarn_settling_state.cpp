#include "core/simulation/yarn_settling.h"

#include <algorithm>

namespace knittsim::simulation {

using physics::Entry;

std::vector<float> YarnSettling::tension() const {
    if (!m_model) {
        return {};
    }
    const std::vector<double> bySegment = m_model->stretch().tensions(shape());
    const double unit = m_yarns.units.forceMilliNewton();
    std::vector<float> result;
    std::size_t first = 0; // segment of the chain
    for (const physics::Chain& chain : m_yarns.chains.chains) {
        const auto segments = static_cast<std::size_t>(chain.segmentCount());
        for (std::size_t i = 0; i <= segments; ++i) {
            const double before = bySegment[first + (i > 0 ? i - 1 : 0)];
            const double after = bySegment[first + std::min(i, segments - 1)];
            result.push_back(static_cast<float>(0.5 * unit * (before + after)));
        }
        first += segments;
    }
    return result;
}

/// What yarns press on each other with, by node, EI/d^2.
physics::Vector YarnSettling::pressing() const {
    physics::Vector gradient = physics::Vector::Zero(shape().size());
    m_model->contact().evaluate(shape(), &gradient);
    m_model->cores().evaluate(shape(), &gradient);
    return gradient;
}

std::vector<float> YarnSettling::contactForce() const {
    if (!m_model) {
        return {};
    }
    const physics::Vector gradient = pressing();
    const double unit = m_yarns.units.forceMilliNewton() / m_yarns.units.lengthMm;
    const std::vector<double> lengths = physics::nodeLengths(m_yarns.chains);
    std::vector<float> result;
    for (std::size_t e = 0; e < lengths.size(); ++e) {
        const double force = physics::at(gradient, static_cast<Entry>(e)).norm();
        result.push_back(static_cast<float>(unit * force / lengths[e]));
    }
    return result;
}

YarnPicture YarnSettling::picture() const {
    return {curves(), entryPositions(m_fabric, m_yarns, shape()), tension(), contactForce()};
}

/// On whose yarn a node is; -1 for none.
machine::LoopIndex YarnSettling::loopAt(Entry node) const {
    return node < 0 ? -1
                    : m_fabric.points[static_cast<std::size_t>(m_yarns.piece[static_cast<std::size_t>(node)])]
                          .loop;
}

YarnAudit YarnSettling::audit() const {
    YarnAudit audit;
    if (*m_problem != '\0') {
        return audit;
    }
    const physics::StrandAudit strands = physics::StrandGuard(m_yarns.chains).audit(shape());
    audit.coreOverlaps = strands.coreOverlaps;
    audit.deepestOverlapMm = strands.deepestOverlap * m_yarns.units.lengthMm;
    audit.worstLoop = loopAt(strands.worstA);
    audit.worstOther = loopAt(strands.worstB);
    audit.passages = m_passages;
    const geometry::YarnCurves laid = curvesOf(m_laid, m_laid.chains.start());
    audit.laidWrong = geometry::certifyTopology(m_fabric, laid).failures;
    const geometry::CrossingAudit start =
        geometry::auditCrossings(m_fabric, laid, geometry::projectCrossings(laid));
    audit.expectedCrossings = start.expected;
    audit.laidCrossings = start.found;
    const geometry::YarnCurves drawn = curves();
    audit.foldedLoops = geometry::certifyTopology(m_fabric, drawn).failures.size();
    audit.foundCrossings = geometry::auditCrossings(m_fabric, drawn, geometry::projectCrossings(drawn)).found;
    return audit;
}

} // namespace knittsim::simulation
