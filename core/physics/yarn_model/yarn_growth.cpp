#include "core/physics/yarn_model/yarn_growth.h"

#include "core/base/segment_distance.h"
#include "core/physics/yarn_model/near_places.h"

#include <algorithm>
#include <cmath>

namespace knittsim::physics {

namespace {
constexpr double kShell = 0.5;   ///< of the soft shell that strands keep between their cores
constexpr double kSkin = 0.5;    ///< of the range
constexpr double kAhead = 1.6;   ///< range over what the yarns keep apart by now
constexpr double kGrowth = 1.05; ///< in a sweep
constexpr double kSmoothing = 0.15;
constexpr double kRelaxation = 1.2;
constexpr double kNearest = 0.1; ///< of what strands keep apart by now
} // namespace

YarnGrowth::YarnGrowth(const YarnChains& chains, std::vector<Entry> fixed, double thickness)
    : m_chains(chains.chains), m_own(chains), m_fixed(std::move(fixed)), m_thickness(thickness),
      m_skin(chains.nodeCount(), -1, 0) {
    for (const Chain& chain : chains.chains) {
        const RodYarn& yarn = chains.yarns[static_cast<std::size_t>(chain.yarn)];
        const double wanted = yarn.coreDiameter + kShell * (yarn.outerDiameter - yarn.coreDiameter);
        for (Entry i = 0; i < chain.segmentCount(); ++i) {
            const Entry node = chain.first + i;
            const double rest = chains.restLength[static_cast<std::size_t>(node)];
            m_segments.push_back({node, yarn.coreDiameter, wanted, rest,
                                  OwnStretch::kExclusion * 0.5 * yarn.outerDiameter + rest});
        }
        m_thickest = std::max(m_thickest, wanted);
    }
}

/// Thin yarns need to know little of what lies around them.
void YarnGrowth::widen() {
    if (m_range < std::min(m_thickest, m_thickness * m_thickest)) {
        m_range = std::min(m_thickest, kAhead * m_thickness * m_thickest);
        m_skin = Skin(m_skin.nodeCount(), -1, kSkin * m_range);
    }
}

void YarnGrowth::findPairs(const Vector& x) {
    const Skin::Age age = m_skin.renew(x, m_range);
    if (age == Skin::Age::Fresh) {
        return;
    }
    const Vector& places = m_skin.reference();
    Eigen::Matrix3Xd middles(3, static_cast<Eigen::Index>(m_segments.size()));
    std::vector<char> moved(m_segments.size(), 0);
    double longest = 0;
    for (std::size_t i = 0; i < m_segments.size(); ++i) {
        const Entry node = m_segments[i].node;
        middles.col(static_cast<Eigen::Index>(i)) = 0.5 * (at(places, node) + at(places, node + 1));
        longest = std::max(longest, (at(places, node + 1) - at(places, node)).norm());
        moved[i] = age == Skin::Age::Partly && (m_skin.moved(node) || m_skin.moved(node + 1)) ? 1 : 0;
    }
    const double range = m_range + m_skin.thickness() + longest;
    if (age == Skin::Age::Partly) {
        std::erase_if(m_pairs, [&](const Pair& p) { return moved[p.a] != 0 || moved[p.b] != 0; });
        addPairs(findNearPairsOf(middles, moved, range));
    } else {
        m_pairs.clear();
        addPairs(findNearPairs(middles, std::nullopt, range));
    }
}

void YarnGrowth::addPairs(const std::vector<NearPair>& near) {
    const Vector& x = m_skin.reference();
    for (const NearPair& pair : near) {
        const auto a = static_cast<std::uint32_t>(pair.a);
        const auto b = static_cast<std::uint32_t>(pair.b.node);
        const Entry nodeA = m_segments[a].node;
        const Entry nodeB = m_segments[b].node;
        if (std::abs(nodeA - nodeB) <= 1) {
            continue; // they share a node, or nothing lies between them
        }
        const double distance =
            closestPoints(at(x, nodeA), at(x, nodeA + 1), at(x, nodeB), at(x, nodeB + 1)).distance;
        if (distance < m_range + m_skin.thickness()) {
            m_pairs.push_back({a, b, m_own.along(nodeA, {nodeB, 0, 0}) < m_segments[a].exclusion});
        }
    }
}

void YarnGrowth::pullLengths(const Vector& x) {
    for (const Segment& s : m_segments) {
        const Eigen::Vector3d way = at(x, s.node + 1) - at(x, s.node);
        const double length = way.norm();
        if (length > 0) {
            const Eigen::Vector3d move = (0.5 * (1 - s.rest / length)) * way;
            add(s.node, move, 1);
            add(s.node + 1, -move, 1);
        }
    }
}

void YarnGrowth::smooth(const Vector& x) {
    for (const Chain& c : m_chains) {
        for (Entry e = c.first + 1; e < c.first + c.count - 1; ++e) {
            add(e, 0.5 * (at(x, e - 1) + at(x, e + 1)) - at(x, e), kSmoothing);
        }
    }
}

void YarnGrowth::pushApart(const Vector& x) {
    m_room = 1e300;
    for (const Pair& pair : m_pairs) {
        const Segment& a = m_segments[pair.a];
        const Segment& b = m_segments[pair.b];
        const Eigen::Vector3d a0 = at(x, a.node);
        const Eigen::Vector3d a1 = at(x, a.node + 1);
        const Eigen::Vector3d b0 = at(x, b.node);
        const Eigen::Vector3d b1 = at(x, b.node + 1);
        // Balls around the segments: most pairs are not that near.
        const double balls = m_range + 0.5 * ((a1 - a0).norm() + (b1 - b0).norm());
        if ((b0 + b1 - a0 - a1).squaredNorm() >= 4 * balls * balls) {
            continue;
        }
        const ClosestPoints closest = closestPoints(a0, a1, b0, b1);
        for (const Entry e : {a.node, a.node + 1, b.node, b.node + 1}) {
            double& clearance = m_clearance[static_cast<std::size_t>(e)];
            clearance = std::min(clearance, closest.distance);
        }
        if (pair.oneStrand) {
            continue;
        }
        m_room = std::min(m_room, closest.distance / (0.5 * (a.core + b.core)));
        const double missing = m_thickness * 0.5 * (a.wanted + b.wanted) - closest.distance;
        if (missing <= 0 || closest.distance <= 0) {
            continue;
        }
        const double s = closest.s;
        const double t = closest.t;
        const Eigen::Vector3d apart = (b0 + t * (b1 - b0) - a0 - s * (a1 - a0)) / closest.distance;
        const double squares = (1 - s) * (1 - s) + s * s + (1 - t) * (1 - t) + t * t;
        const Eigen::Vector3d move = (missing / squares) * apart;
        add(a.node, -(1 - s) * move, 1);
        add(a.node + 1, -s * move, 1);
        add(b.node, (1 - t) * move, 1);
        add(b.node + 1, t * move, 1);
    }
}

double YarnGrowth::sweep(Vector& x) {
    widen();
    findPairs(x);
    const auto nodes = static_cast<std::size_t>(x.size() / 3);
    m_move.setZero(x.size());
    m_weight.assign(nodes, 0);
    m_clearance.assign(nodes, m_range);
    pushApart(x);
    m_push = m_move;
    m_pushes = m_weight;
    pullLengths(x);
    smooth(x);
    for (const Entry e : m_fixed) {
        at(m_move, e).setZero();
        at(m_push, e).setZero();
    }
    double largest = 0;
    for (std::size_t i = 0; i < nodes; ++i) {
        const auto e = static_cast<Entry>(i);
        // What lengths press together sweep after sweep would end up touching: near strands, only they count.
        const bool pressed = m_clearance[i] < kNearest * m_thickness * m_thickest;
        const double weight = pressed ? m_pushes[i] : m_weight[i];
        Eigen::Vector3d move = at(pressed ? m_push : m_move, e) * (kRelaxation / std::max(1.0, weight));
        const double length = move.norm();
        const double most = kShare * m_clearance[i];
        if (length > most) {
            move *= most / length;
        }
        at(x, e) += move;
        largest = std::max(largest, std::min(length, most));
    }
    m_thickness = std::min(1.0, m_thickness * kGrowth);
    return largest;
}

} // namespace knittsim::physics
