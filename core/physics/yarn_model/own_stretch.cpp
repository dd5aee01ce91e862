#include "core/physics/yarn_model/own_stretch.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace knittsim::physics {

OwnStretch::OwnStretch(const YarnChains& chains)
    : m_chains(chains.chains), m_chainOf(static_cast<std::size_t>(chains.nodeCount())),
      m_arc(arcLengths(chains)) {
    for (std::size_t c = 0; c < m_chains.size(); ++c) {
        const Chain& chain = m_chains[c];
        const auto last = static_cast<std::size_t>(chain.first + chain.count - 1);
        m_chainLength.push_back(m_arc[last] + (chain.closed ? chains.restLength[last] : 0));
        for (Entry i = 0; i < chain.count; ++i) {
            m_chainOf[static_cast<std::size_t>(chain.first + i)] = static_cast<int>(c);
        }
    }
}

double OwnStretch::along(Entry a, const Place& b) const {
    constexpr double kNoWay = std::numeric_limits<double>::infinity();
    if (chainOf(a) != chainOf(b.node)) {
        return kNoWay;
    }
    const Chain& chain = m_chains[chainOf(a)];
    const double direct = m_arc[static_cast<std::size_t>(b.node)] - m_arc[static_cast<std::size_t>(a)];
    double least = b.isImage() ? kNoWay : std::abs(direct);
    if (!chain.closed) {
        return least;
    }
    // Going round leads to the next image, or back to the same place.
    for (int turns = -2; turns <= 2; ++turns) {
        if (turns * chain.across == b.across && turns * chain.up == b.up) {
            least = std::min(least, std::abs(direct + turns * m_chainLength[chainOf(a)]));
        }
    }
    return least;
}

} // namespace knittsim::physics
