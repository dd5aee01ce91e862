#include "core/export/writers.h"
#include "core/machine/needle.h"

namespace knittsim::exports {

namespace {

constexpr std::size_t kBetweenReports = 4096;

const char* roleText(fabric::Role role) {
    return role == fabric::Role::Foot ? "foot" : role == fabric::Role::Head ? "head" : "crossing";
}

} // namespace

void writePointsCsv(Output& out, const Shape& shape) {
    const fabric::Fabric& fabric = *shape.fabric;
    out.write("yarn,carrier,point,entry,loop,role,side,front,course,needle,x_mm,y_mm,z_mm,to_next_mm\n");
    for (std::size_t y = 0; y < fabric.yarns.size(); ++y) {
        const fabric::Yarn& yarn = fabric.yarns[y];
        for (fabric::PointIndex i = yarn.first; i < yarn.first + yarn.count; ++i) {
            const auto p = static_cast<std::size_t>(i);
            if (p % kBetweenReports == 0) {
                out.advance(static_cast<double>(p) / static_cast<double>(fabric.points.size()));
            }
            if (!shape.keep.empty() && !shape.keep[p]) {
                continue;
            }
            const fabric::BondingPoint& point = fabric.points[p];
            const std::size_t at = 3 * static_cast<std::size_t>(point.entry);
            out.print("{},{},{},{},{},{},{},{},{},{},{:.5f},{:.5f},{:.5f},{:.5f}\n", y + 1, yarn.carrier + 1,
                      i, point.entry, point.loop, roleText(point.role),
                      point.side == fabric::Side::Left ? "left" : "right", point.front,
                      point.loop >= 0 ? fabric.loops[static_cast<std::size_t>(point.loop)].course + 1 : 0,
                      machine::toString(point.needle), shape.places[at], shape.places[at + 1],
                      shape.places[at + 2], fabric.lengths[p]);
        }
    }
}

} // namespace knittsim::exports
