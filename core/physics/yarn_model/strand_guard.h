#pragma once

#include "core/physics/yarn_model/chains.h"
#include "core/physics/yarn_model/near_places.h"
#include "core/physics/yarn_model/own_stretch.h"
#include "core/physics/yarn_model/skin.h"

#include <algorithm>
#include <initializer_list>
#include <vector>

namespace knittsim::physics {

/// What the strands of a shape do to each other. A stretch of yarn too short to touch itself is one strand.
struct StrandAudit {
    double smallestDistance =
        0; ///< of the middles of two strands; infinite when all are more than half a yarn apart
    int coreOverlaps = 0;      ///< pairs of segments nearer than their core diameter
    double deepestOverlap = 0; ///< core diameter - distance of the worst one
    double worstCore = 0;      ///< core diameter of the nearest ones
    Entry worstA = -1;         ///< the segments after these nodes are the nearest ones
    Entry worstB = -1;
};

/// Sees to it that no strand ever passes through another. While a step is made, no two points of two segments
/// move against each other by more than kShare of the distance of the segments, so they stay apart on the
/// whole way (conservative advancement). All segments count but those that share a node.
///
/// Nearby segments come from a grid with a skin. For each of them the last known distance, less what they
/// have moved since, is a lower bound; only where that does not do is the distance computed anew.
class StrandGuard {
public:
    static constexpr double kShare = 0.6;

    explicit StrandGuard(const YarnChains& chains);

    /// Largest factor in [0, 1] by which `move` may be made from x.
    double allowed(const Vector& x, const Vector& move);

    /// Lowers the shares (by node) by which `move` may be made from x where pairs of segments are in the way:
    /// a help to shorten a move only where that is needed. What it leaves is for `allowed` to check.
    void lowerShares(const Vector& x, const Vector& move, std::vector<double>& share);

    /// share[node] = min(share[node], by)
    static void lower(std::vector<double>& share, std::initializer_list<Entry> nodes, double by) {
        for (const Entry e : nodes) {
            double& own = share[static_cast<std::size_t>(e)];
            own = std::min(own, by);
        }
    }

    /// Core diameters are those of the yarns times `thickness`.
    StrandAudit audit(const Vector& x, double thickness = 1);

private:
    struct Segment {
        Entry node = 0; ///< its first one
        Place next;     ///< its second one
        double core = 0;
        double stretch = 0;  ///< yarn within which it is one strand with itself
        double odometer = 0; ///< bound on how far its points have gone
    };
    struct Pair {
        std::uint32_t a = 0;
        std::uint32_t b = 0;
        int across = 0; ///< image of b
        int up = 0;
        double distance = 0; ///< when it was last computed
        double odometer = 0; ///< of both segments, then
        bool oneStrand = false;
    };

    Place first(const Segment& s, int across, int up) const { return {s.node, across, up}; }
    Place second(const Segment& s, int across, int up) const {
        return {s.next.node, s.next.across + across, s.next.up + up};
    }
    bool neighbours(const NearPair& pair) const;
    double distanceOf(const Vector& x, const Pair& pair) const;
    double relativeMotion(const Vector& move, const Pair& pair) const;
    double odometer(const Pair& pair) const {
        return m_segments[pair.a].odometer + m_segments[pair.b].odometer;
    }
    double lowerBound(const Pair& pair) const { return pair.distance - (odometer(pair) - pair.odometer); }
    void renewDistance(const Vector& x, Pair& pair) const {
        pair.distance = distanceOf(x, pair);
        pair.odometer = odometer(pair);
    }
    void prepare(const Vector& x);
    void turnOdometers(const Vector& x);
    void findPairs(const Vector& x);
    void addPairs(const Vector& x, const std::vector<NearPair>& near);

    std::vector<Segment> m_segments;
    OwnStretch m_own;
    Entry m_nodeCount;
    Entry m_cell;
    double m_range = 0; ///< pairs farther apart than this (middles of strands) need not be known
    std::vector<Pair> m_pairs;
    Skin m_skin;
    Vector m_last; ///< shape that was asked about last
};

} // namespace knittsim::physics
