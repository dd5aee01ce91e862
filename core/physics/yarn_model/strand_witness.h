#pragma once

#include "core/physics/yarn_model/chains.h"

#include <cstdint>
#include <vector>

namespace knittsim::physics {

/// Follows a shape on its way and proves, pair by pair, that no strand passes through another: while the
/// nodes go straight from one shape to the next, the distance of two segments shrinks by no more than they
/// move against each other, so as many looks on the way as that asks for show that they stay apart
/// (conservative advancement). Whoever moved the yarns need not have taken care: a way without a meeting is
/// an isotopy, and what it began with is knotted as what it ends with.
///
/// It shares no bookkeeping with StrandGuard. A pair that was far apart is looked at again once it can have
/// come near. A shift that all nodes have in common does not count. Linear in the nodes. Chains without a
/// cell only.
class StrandWitness {
public:
    explicit StrandWitness(const YarnChains& chains);

    /// The segments after these nodes came nearer than kTouch.
    struct Meeting {
        Entry a = 0;
        Entry b = 0;
    };
    static constexpr double kTouch = 1e-9; ///< d

    /// Every node went straight from its place in `from` to its place in `to`. Returns who met on the way.
    std::vector<Meeting> follow(const Vector& from, const Vector& to);

private:
    struct Segment {
        Entry node = 0; ///< its first one, the other is the next
        double way = 0; ///< bound on how far its points have gone
    };
    struct Pair {
        std::uint32_t a = 0;
        std::uint32_t b = 0;
        double apartUntil = 0; ///< sum of both ways up to which they stay apart for certain
    };

    void findPairs(const Vector& x, double reach);
    bool meet(const Vector& from, const Vector& to, Pair& pair, double gone) const;

    std::vector<Segment> m_segments;
    std::vector<Pair> m_pairs;
    double m_usual = 0; ///< reach, as long as no step is longer than that
    double m_reach = 0; ///< who is not in a pair was farther apart when pairs were found
    double m_gone = 0;  ///< largest way since then
};

} // namespace knittsim::physics
