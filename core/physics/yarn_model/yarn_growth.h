#pragma once

#include "core/physics/yarn_model/chains.h"
#include "core/physics/yarn_model/near_places.h"
#include "core/physics/yarn_model/own_stretch.h"
#include "core/physics/yarn_model/skin.h"

#include <vector>

namespace knittsim::physics {

/// Yarns of vanishing thickness that grow to their own diameter and make room for each other: position based
/// dynamics (Jacobi) on lengths, distances and, weakly, smoothness. It knows no forces; its shape is where
/// the search for rest may begin. A sweep is linear in the nodes.
///
/// No strand passes through another: in a sweep no node moves by more than kShare of the distance from the
/// segments at it to any other segment that does not share a node with them, and kShare is less than half.
///
/// Chains without a cell only.
class YarnGrowth {
public:
    static constexpr double kShare = 0.45;
    static constexpr double kThinnest = 0.05;

    /// `fixed`: nodes that stay where they are. `thickness` to begin with.
    YarnGrowth(const YarnChains& chains, std::vector<Entry> fixed, double thickness = kThinnest);

    /// Moves x. Returns the largest move of a node.
    double sweep(Vector& x);

    /// Share of the wanted distances that yarns keep by now; 1 when grown up.
    double thickness() const { return m_thickness; }

    /// Smallest distance of two strands over the sum of their core radii, before the last sweep.
    double room() const { return m_room; }

private:
    struct Segment {
        Entry node = 0; ///< its first one, the other is the next
        double core = 0;
        double wanted = 0; ///< diameter
        double rest = 0;
        double exclusion = 0; ///< yarn within which it does not touch itself
    };
    struct Pair {
        std::uint32_t a = 0;
        std::uint32_t b = 0;
        bool oneStrand = false;
    };

    void widen();
    void findPairs(const Vector& x);
    void addPairs(const std::vector<NearPair>& near);
    void pullLengths(const Vector& x);
    void pushApart(const Vector& x);
    void smooth(const Vector& x);
    void add(Entry node, const Eigen::Vector3d& move, double weight) {
        at(m_move, node) += weight * move;
        m_weight[static_cast<std::size_t>(node)] += weight;
    }

    std::vector<Chain> m_chains;
    OwnStretch m_own;
    std::vector<Segment> m_segments;
    std::vector<Entry> m_fixed;
    double m_thickest = 0; ///< largest wanted diameter
    double m_range = 0;    ///< farther strands need not be known by now
    double m_thickness;
    double m_room = 0;
    Skin m_skin;
    std::vector<Pair> m_pairs;
    Vector m_move;
    std::vector<double> m_weight;    ///< by node
    Vector m_push;                   ///< the part of m_move that pushes strands apart
    std::vector<double> m_pushes;    ///< by node, its weight
    std::vector<double> m_clearance; ///< by node
};

} // namespace knittsim::physics
