#include "core/fabric/depth_order.h"

#include <algorithm>
#include <tuple>

namespace knittsim::fabric {

void orderInDepth(const Fabric& fabric, EntryIndex entry, ClaspLevel level, std::vector<PointIndex>& row) {
    const auto made = [&](PointIndex p) -> const machine::Loop& {
        const LoopIndex loop = fabric.points[static_cast<std::size_t>(p)].loop;
        return fabric.made.loops[static_cast<std::size_t>(loop)];
    };
    const auto key = [&](PointIndex p) {
        const BondingPoint& point = fabric.points[static_cast<std::size_t>(p)];
        const Loop& loop = fabric.loops[static_cast<std::size_t>(point.loop)];
        if (point.role == Role::Head) {
            const int towardsBed = machine::isFront(loop.bound.bed) ? 1 : -1;
            return std::tuple{0, 0, -towardsBed * loop.stackPlace};
        }
        const int pulled = machine::isFront(made(p).needle.bed) ? 1 : -1;
        const int place = level == ClaspLevel::Upper ? pulled : -pulled;
        return std::tuple{place, made(p).operation, -pulled * loop.plating};
    };
    row.clear();
    for (const PointIndex p : fabric.at(entry)) {
        if (fabric.points[static_cast<std::size_t>(p)].role != Role::Crossing) {
            row.push_back(p);
        }
    }
    std::ranges::sort(row, {}, key);
}

} // namespace knittsim::fabric
