#pragma once

#include "core/base/vec3.h"
#include "core/fabric/fabric.h"

#include <optional>
#include <span>
#include <vector>

namespace knittsim::geometry {

/// Where the stitches of each wale and course are: the mean of the heads of the loops there, mm.
struct StitchLattice {
    int wales = 0;
    int courses = 0;
    std::vector<std::optional<Vec3f>> places; ///< course by course, from the left; nothing where no loop is

    const std::optional<Vec3f>& at(int wale, int course) const {
        return places[static_cast<std::size_t>(course) * static_cast<std::size_t>(wales) +
                      static_cast<std::size_t>(wale)];
    }
};

/// `positions`: 3 per entry, mm. Loops that have run down are left out.
StitchLattice stitchLattice(const fabric::Fabric& fabric, std::span<const float> positions);

} // namespace knittsim::geometry
