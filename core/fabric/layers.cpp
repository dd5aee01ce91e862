#include "core/fabric/layers.h"

#include <algorithm>

namespace knittsim::fabric {

namespace {

bool isIn(const Fabric& fabric, const std::vector<bool>& layer, PointIndex point) {
    return layer[static_cast<std::size_t>(fabric.points[static_cast<std::size_t>(point)].loop)];
}

} // namespace

bool canBePulledApart(const Fabric& fabric, const std::vector<bool>& front) {
    for (EntryIndex entry = 0; entry < fabric.entryCount; ++entry) {
        const auto points = fabric.at(entry);
        const auto inFront = [&](PointIndex p) { return isIn(fabric, front, p); };
        const bool bonding = fabric.points[static_cast<std::size_t>(points[0])].role != Role::Crossing;
        if (bonding && std::ranges::any_of(points, inFront) && !std::ranges::all_of(points, inFront)) {
            return false;
        }
    }
    return std::ranges::none_of(fabric.crossings, [&](const Crossing& crossing) {
        return isIn(fabric, front, crossing.under) && !isIn(fabric, front, crossing.over);
    });
}

int crossingsBetween(const Fabric& fabric, const std::vector<bool>& front) {
    return static_cast<int>(std::ranges::count_if(fabric.crossings, [&](const Crossing& crossing) {
        return isIn(fabric, front, crossing.under) != isIn(fabric, front, crossing.over);
    }));
}

} // namespace knittsim::fabric
