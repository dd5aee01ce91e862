#pragma once

#include "core/physics/yarn_model/chains.h"

#include <vector>

namespace knittsim::physics {

/// How far two places are from each other along their yarn.
class OwnStretch {
public:
    explicit OwnStretch(const YarnChains& chains);

    /// Yarn between them; infinite when no yarn leads from one to the other.
    double along(Entry a, const Place& b) const;

    int yarnOf(Entry node) const { return m_chains[chainOf(node)].yarn; }

    /// Yarn does not touch itself within this many outer radii along itself (PHYSICS-REFERENCE 2.4).
    static constexpr double kExclusion = 2.1;

private:
    std::size_t chainOf(Entry node) const {
        return static_cast<std::size_t>(m_chainOf[static_cast<std::size_t>(node)]);
    }

    std::vector<Chain> m_chains;
    std::vector<int> m_chainOf;        ///< by node
    std::vector<double> m_arc;         ///< by node
    std::vector<double> m_chainLength; ///< by chain; with the closing segment
};

} // namespace knittsim::physics
