#include "core/physics/yarn_model/strand_guard.h"

#include "core/base/segment_distance.h"
#include "core/physics/yarn_model/skin.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace knittsim::physics {

namespace {
constexpr double kRange = 0.6; ///< outer diameters of the thickest yarn
constexpr double kCores = 1.2; ///< and core diameters at least
constexpr double kSkin = 0.4;

double rangeOf(const YarnChains& chains) {
    double range = 0;
    for (const Chain& chain : chains.chains) {
        const RodYarn& yarn = chains.yarns[static_cast<std::size_t>(chain.yarn)];
        range = std::max({range, kRange * yarn.outerDiameter, kCores * yarn.coreDiameter});
    }
    return range;
}
} // namespace

StrandGuard::StrandGuard(const YarnChains& chains)
    : m_own(chains), m_nodeCount(chains.nodeCount()), m_cell(chains.cellEntry()), m_range(rangeOf(chains)),
      m_skin(m_nodeCount, m_cell, kSkin * m_range) {
    for (const Chain& chain : chains.chains) {
        const RodYarn& yarn = chains.yarns[static_cast<std::size_t>(chain.yarn)];
        const double exclusion = OwnStretch::kExclusion * 0.5 * yarn.outerDiameter;
        for (Entry i = 0; i < chain.segmentCount(); ++i) {
            const Entry node = chain.first + i;
            const double rest = chains.restLength[static_cast<std::size_t>(node)];
            m_segments.push_back({node, chain.place(i + 1), yarn.coreDiameter, exclusion + rest});
        }
    }
}

/// Share a node.
bool StrandGuard::neighbours(const NearPair& pair) const {
    const Segment& a = m_segments[static_cast<std::size_t>(pair.a)];
    const Segment& b = m_segments[static_cast<std::size_t>(pair.b.node)];
    const Place a0 = first(a, 0, 0);
    const Place a1 = second(a, 0, 0);
    const Place b0 = first(b, pair.b.across, pair.b.up);
    const Place b1 = second(b, pair.b.across, pair.b.up);
    return a0 == b0 || a0 == b1 || a1 == b0 || a1 == b1;
}

double StrandGuard::distanceOf(const Vector& x, const Pair& pair) const {
    const Segment& a = m_segments[pair.a];
    const Segment& b = m_segments[pair.b];
    return closestPoints(at(x, a.node), position(x, m_cell, a.next),
                         position(x, m_cell, first(b, pair.across, pair.up)),
                         position(x, m_cell, second(b, pair.across, pair.up)))
        .distance;
}

/// The difference of two points of the segments is linear in the place on each, so the corners bound it.
double StrandGuard::relativeMotion(const Vector& move, const Pair& pair) const {
    const Segment& a = m_segments[pair.a];
    const Segment& b = m_segments[pair.b];
    const Eigen::Vector3d a0 = at(move, a.node);
    const Eigen::Vector3d a1 = position(move, m_cell, a.next);
    const Eigen::Vector3d b0 = position(move, m_cell, first(b, pair.across, pair.up));
    const Eigen::Vector3d b1 = position(move, m_cell, second(b, pair.across, pair.up));
    return std::sqrt(std::max({(a0 - b0).squaredNorm(), (a0 - b1).squaredNorm(), (a1 - b0).squaredNorm(),
                               (a1 - b1).squaredNorm()}));
}

void StrandGuard::turnOdometers(const Vector& x) {
    if (m_last.size() != x.size()) {
        m_skin.forget();
        return;
    }
    // A cell moves its images against each other: then all have gone as far as the bound on any two says.
    const double all =
        m_cell < 0 ? 0
                   : 0.5 * relativeMotionBound(m_last, x, m_nodeCount, m_cell, m_range + m_skin.thickness());
    for (Segment& s : m_segments) {
        s.odometer += m_cell >= 0
                          ? all
                          : std::sqrt(std::max((at(x, s.node) - at(m_last, s.node)).squaredNorm(),
                                               (at(x, s.next.node) - at(m_last, s.next.node)).squaredNorm()));
    }
}

void StrandGuard::findPairs(const Vector& x) {
    const Skin::Age age = m_skin.renew(x, m_range);
    if (age == Skin::Age::Fresh) {
        return;
    }
    const Vector& places = m_skin.reference();
    Eigen::Matrix3Xd middles(3, static_cast<Eigen::Index>(m_segments.size()));
    std::vector<char> moved(m_segments.size(), 0);
    double longest = 0;
    for (std::size_t i = 0; i < m_segments.size(); ++i) {
        const Segment& s = m_segments[i];
        const Eigen::Vector3d begin = at(places, s.node);
        const Eigen::Vector3d end = position(places, m_cell, s.next);
        middles.col(static_cast<Eigen::Index>(i)) = 0.5 * (begin + end);
        longest = std::max(longest, (end - begin).norm());
        moved[i] = age == Skin::Age::Partly && (m_skin.moved(s.node) || m_skin.moved(s.next.node)) ? 1 : 0;
    }
    const double range = m_range + m_skin.thickness() + longest;
    if (age == Skin::Age::Partly) {
        std::erase_if(m_pairs, [&](const Pair& p) { return moved[p.a] != 0 || moved[p.b] != 0; });
        addPairs(x, findNearPairsOf(middles, moved, range));
    } else {
        m_pairs.clear();
        addPairs(x, findNearPairs(middles, cellAt(x, m_cell), range));
    }
}

void StrandGuard::addPairs(const Vector& x, const std::vector<NearPair>& near) {
    for (const NearPair& found : near) {
        if (neighbours(found)) {
            continue;
        }
        Pair pair{static_cast<std::uint32_t>(found.a),
                  static_cast<std::uint32_t>(found.b.node),
                  found.b.across,
                  found.b.up,
                  0,
                  0,
                  false};
        if (distanceOf(m_skin.reference(), pair) < m_range + m_skin.thickness()) {
            renewDistance(x, pair);
            const Segment& a = m_segments[pair.a];
            const Place b = first(m_segments[pair.b], pair.across, pair.up);
            pair.oneStrand = m_own.along(a.node, b) < a.stretch;
            m_pairs.push_back(pair);
        }
    }
}

void StrandGuard::prepare(const Vector& x) {
    turnOdometers(x);
    findPairs(x);
    m_last = x;
}

double StrandGuard::allowed(const Vector& x, const Vector& move) {
    if (!x.allFinite() || !move.allFinite()) {
        return 0;
    }
    prepare(x);
    // Strands that are not known to be near are farther apart than the range.
    const double any = relativeMotionBound(x, x + move, m_nodeCount, m_cell, m_range);
    double factor = std::min(1.0, kShare * m_range / std::max(any, 1e-300));
    for (Pair& pair : m_pairs) {
        const double motion = relativeMotion(move, pair);
        if (factor * motion <= kShare * lowerBound(pair)) {
            continue;
        }
        renewDistance(x, pair);
        if (factor * motion > kShare * pair.distance) {
            factor = kShare * pair.distance / motion;
        }
    }
    return factor;
}

void StrandGuard::lowerShares(const Vector& x, const Vector& move, std::vector<double>& share) {
    prepare(x);
    for (Pair& pair : m_pairs) {
        const double motion = relativeMotion(move, pair);
        if (motion <= kShare * lowerBound(pair)) {
            continue;
        }
        renewDistance(x, pair);
        if (motion > kShare * pair.distance) {
            const Segment& a = m_segments[pair.a];
            const Segment& b = m_segments[pair.b];
            lower(share, {a.node, a.next.node, b.node, b.next.node}, kShare * pair.distance / motion);
        }
    }
    // Strands that are not known to be near are farther apart than the range.
    const double any = 0.5 * kShare * m_range;
    for (Entry e = 0; e < m_nodeCount; ++e) {
        const double own = at(move, e).norm();
        if (own > any) {
            lower(share, {e}, any / own);
        }
    }
}

StrandAudit StrandGuard::audit(const Vector& x, double thickness) {
    StrandAudit result;
    result.smallestDistance = std::numeric_limits<double>::infinity();
    if (!x.allFinite()) {
        result.smallestDistance = 0;
        return result;
    }
    m_last.resize(0);
    prepare(x);
    for (const Pair& pair : m_pairs) {
        if (pair.oneStrand) {
            continue;
        }
        const Segment& a = m_segments[pair.a];
        const Segment& b = m_segments[pair.b];
        const double core = 0.5 * thickness * (a.core + b.core);
        if (pair.distance < core) {
            ++result.coreOverlaps;
            result.deepestOverlap = std::max(result.deepestOverlap, core - pair.distance);
        }
        if (pair.distance < result.smallestDistance) {
            result.smallestDistance = pair.distance;
            result.worstCore = core;
            result.worstA = a.node;
            result.worstB = b.node;
        }
    }
    return result;
}

} // namespace knittsim::physics
