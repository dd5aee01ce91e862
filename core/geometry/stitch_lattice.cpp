#include "core/geometry/stitch_lattice.h"

#include "core/geometry/measure.h"

#include <algorithm>

namespace knittsim::geometry {

StitchLattice stitchLattice(const fabric::Fabric& fabric, std::span<const float> positions) {
    const std::vector<int> wale = waleNumbers(fabric);
    StitchLattice lattice;
    lattice.courses = fabric.courseCount;
    for (const int w : wale) {
        lattice.wales = std::max(lattice.wales, w + 1);
    }
    const std::size_t cells =
        static_cast<std::size_t>(lattice.wales) * static_cast<std::size_t>(lattice.courses);
    lattice.places.resize(cells);
    std::vector<int> heads(cells, 0);
    for (std::size_t i = 0; i < fabric.loops.size(); ++i) {
        const fabric::Loop& loop = fabric.loops[i];
        for (const fabric::PointIndex head : {loop.headLeft, loop.headRight}) {
            if (head < 0) {
                continue;
            }
            const auto at = 3 * static_cast<std::size_t>(fabric.points[static_cast<std::size_t>(head)].entry);
            const std::size_t cell =
                static_cast<std::size_t>(loop.course) * static_cast<std::size_t>(lattice.wales) +
                static_cast<std::size_t>(wale[i]);
            const Vec3f place(positions[at], positions[at + 1], positions[at + 2]);
            lattice.places[cell] = lattice.places[cell].value_or(Vec3f(Vec3f::Zero())) + place;
            ++heads[cell];
        }
    }
    for (std::size_t cell = 0; cell < cells; ++cell) {
        if (heads[cell] > 0) {
            *lattice.places[cell] /= static_cast<float>(heads[cell]);
        }
    }
    return lattice;
}

} // namespace knittsim::geometry
