#include "core/fabric/entry_index.h"

namespace knittsim::fabric {

void indexEntries(Fabric& fabric) {
    fabric.firstOfEntry.assign(static_cast<std::size_t>(fabric.entryCount) + 1, 0);
    for (const BondingPoint& point : fabric.points) {
        ++fabric.firstOfEntry[static_cast<std::size_t>(point.entry) + 1];
    }
    for (std::size_t e = 1; e < fabric.firstOfEntry.size(); ++e) {
        fabric.firstOfEntry[e] += fabric.firstOfEntry[e - 1];
    }
    fabric.pointsOfEntry.resize(fabric.points.size());
    std::vector<std::int32_t> next(fabric.firstOfEntry.begin(), fabric.firstOfEntry.end() - 1);
    for (std::size_t p = 0; p < fabric.points.size(); ++p) {
        const auto slot = next[static_cast<std::size_t>(fabric.points[p].entry)]++;
        fabric.pointsOfEntry[static_cast<std::size_t>(slot)] = static_cast<PointIndex>(p);
    }
}

} // namespace knittsim::fabric
