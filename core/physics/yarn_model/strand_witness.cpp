#include "core/physics/yarn_model/strand_witness.h"

#include "core/base/segment_distance.h"
#include "core/physics/yarn_model/near_places.h"

#include <algorithm>
#include <cmath>

namespace knittsim::physics {

namespace {
constexpr double kReach = 0.6;  ///< outer diameters of the thickest yarn
constexpr double kStride = 0.9; ///< of what is sure, from look to look
constexpr int kMostLooks = 1000;
} // namespace

StrandWitness::StrandWitness(const YarnChains& chains) : m_usual(kReach * thickestYarn(chains.yarns)) {
    for (const Chain& chain : chains.chains) {
        for (Entry i = 0; i < chain.segmentCount(); ++i) {
            m_segments.push_back({chain.first + i, 0});
        }
    }
}

void StrandWitness::findPairs(const Vector& x, double reach) {
    m_pairs.clear();
    m_reach = reach;
    m_gone = 0;
    Eigen::Matrix3Xd middles(3, static_cast<Eigen::Index>(m_segments.size()));
    double longest = 0;
    for (std::size_t i = 0; i < m_segments.size(); ++i) {
        const Entry node = m_segments[i].node;
        m_segments[i].way = 0;
        middles.col(static_cast<Eigen::Index>(i)) = 0.5 * (at(x, node) + at(x, node + 1));
        longest = std::max(longest, (at(x, node + 1) - at(x, node)).norm());
    }
    for (const NearPair& near : findNearPairs(middles, std::nullopt, reach + longest)) {
        const Entry a = m_segments[static_cast<std::size_t>(near.a)].node;
        const Entry b = m_segments[static_cast<std::size_t>(near.b.node)].node;
        if (std::abs(a - b) <= 1) {
            continue; // they share a node, or nothing lies between them
        }
        const double apart = closestPoints(at(x, a), at(x, a + 1), at(x, b), at(x, b + 1)).distance;
        if (apart < reach) {
            m_pairs.push_back(
                {static_cast<std::uint32_t>(near.a), static_cast<std::uint32_t>(near.b.node), apart});
        }
    }
}

/// On the way of one step, `gone` being the way of both before it.
bool StrandWitness::meet(const Vector& from, const Vector& to, Pair& pair, double gone) const {
    const Entry a = m_segments[pair.a].node;
    const Entry b = m_segments[pair.b].node;
    const auto way = [&](Entry e) -> Eigen::Vector3d { return at(to, e) - at(from, e); };
    // The difference of two points is linear in the place on each segment: the ends bound it.
    double motion = 0;
    for (const Entry p : {a, a + 1}) {
        for (const Entry q : {b, b + 1}) {
            motion = std::max(motion, (way(p) - way(q)).norm());
        }
    }
    double time = 0;
    for (int look = 0; look < kMostLooks; ++look) {
        const auto place = [&](Entry e) -> Eigen::Vector3d { return at(from, e) + time * way(e); };
        const double apart = closestPoints(place(a), place(a + 1), place(b), place(b + 1)).distance;
        if (look == 0) {
            pair.apartUntil = gone + apart;
        }
        if (!(apart > kTouch)) {
            return true;
        }
        if (apart > (1 - time) * motion) {
            return false;
        }
        time += kStride * apart / motion;
    }
    return true;
}

std::vector<StrandWitness::Meeting> StrandWitness::follow(const Vector& from, const Vector& to) {
    const Eigen::Vector3d shift =
        Eigen::Map<const Eigen::Matrix3Xd>(Vector(to - from).data(), 3, from.size() / 3).rowwise().mean();
    const auto moved = [&](Entry e) { return (at(to, e) - at(from, e) - shift).squaredNorm(); };
    std::vector<double> way(m_segments.size());
    double longest = 0;
    for (std::size_t i = 0; i < m_segments.size(); ++i) {
        const Entry node = m_segments[i].node;
        way[i] = std::sqrt(std::max(moved(node), moved(node + 1)));
        longest = std::max(longest, way[i]);
    }
    // Those that are in no pair have not met while two of the longest ways are less than the reach.
    if (!(2 * (m_gone + longest) < m_reach)) {
        findPairs(from, std::max(m_usual, 4 * longest));
    }
    m_gone += longest;
    std::vector<Meeting> meetings;
    for (Pair& pair : m_pairs) {
        const double gone = m_segments[pair.a].way + m_segments[pair.b].way;
        if (gone + way[pair.a] + way[pair.b] < pair.apartUntil) {
            continue;
        }
        if (meet(from, to, pair, gone)) {
            meetings.push_back({m_segments[pair.a].node, m_segments[pair.b].node});
        }
    }
    for (std::size_t i = 0; i < m_segments.size(); ++i) {
        m_segments[i].way += way[i];
    }
    return meetings;
}

} // namespace knittsim::physics
