#pragma once

#include "core/fabric/fabric.h"

#include <algorithm>
#include <vector>

namespace knittsim::test {

/// Positions (3 per entry, mm) of a flat fabric as if relaxed: wales a quarter and courses 1/5.3 of a loop
/// length apart, as measured on plain knit.
inline std::vector<float> relaxedLattice(const fabric::Fabric& fabric, double loopLengthMm) {
    const double wale = loopLengthMm / 4;
    const double course = loopLengthMm / 5.3;
    std::vector<float> positions(3 * static_cast<std::size_t>(fabric.entryCount));
    for (std::size_t e = 0; e < fabric.machinePositions.size(); ++e) {
        positions[3 * e] = static_cast<float>(fabric.machinePositions[e].x() / fabric.pitchMm * wale);
    }
    for (const fabric::Loop& loop : fabric.loops) {
        for (const fabric::PointIndex head : {loop.headLeft, loop.headRight}) {
            const auto e = static_cast<std::size_t>(fabric.points[static_cast<std::size_t>(head)].entry);
            positions[3 * e + 1] =
                std::max(positions[3 * e + 1], static_cast<float>((loop.course + 1) * course));
        }
    }
    return positions;
}

} // namespace knittsim::test
