#pragma once

#include "core/fabric/fabric_builder.h"
#include "core/pattern/swatch.h"
#include "core/simulation/simulation.h"

#include <cmath>
#include <memory>

namespace knittsim::simulation::test {

inline std::shared_ptr<const fabric::Fabric> build(machine::Program program) {
    return std::make_shared<fabric::Fabric>(
        fabric::buildFabric(machine::Timeline(std::move(program), machine::genericProfile())));
}

inline std::shared_ptr<const fabric::Fabric> plain(int wales = 12, int courses = 12) {
    return build(pattern::makePlain(wales, courses));
}

inline command::Load load(std::shared_ptr<const fabric::Fabric> fabric, std::uint64_t generation = 1) {
    command::Load result;
    result.fabric = std::move(fabric);
    result.generation = generation;
    return result;
}

/// x, y or z of an entry.
inline float coordinate(const Frame& frame, fabric::EntryIndex entry, int axis) {
    return frame.positions[3 * static_cast<std::size_t>(entry) + static_cast<std::size_t>(axis)];
}

inline float distance(const Frame& frame, fabric::EntryIndex a, fabric::EntryIndex b) {
    float sum = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const float d = coordinate(frame, a, axis) - coordinate(frame, b, axis);
        sum += d * d;
    }
    return std::sqrt(sum);
}

} // namespace knittsim::simulation::test
