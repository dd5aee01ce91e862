#pragma once

#include "core/geometry/yarn_curve.h"
#include "tests/support/build.h"
#include "tests/support/lattice.h"

#include <string>
#include <vector>

namespace knittsim::test {

constexpr double kLoopMm = 5;
constexpr double kDiameterMm = kLoopMm / 8.8;

/// Courses knitted back and forth; `beds` names the bed of each needle, 'f' or 'b'.
inline fabric::Fabric knit(const std::string& beds, int courses) {
    std::string lines = "in 1\n";
    const int last = static_cast<int>(beds.size()) - 1;
    for (int course = 0; course < courses; ++course) {
        for (int i = 0; i <= last; ++i) {
            const int needle = course % 2 == 0 ? last - i : i;
            const char bed = beds[static_cast<std::size_t>(needle)];
            lines += std::string("knit ") + (course % 2 == 0 ? '-' : '+') + ' ' + bed +
                     std::to_string(needle) + " 1\n";
        }
    }
    return build(lines + "out 1\n");
}

inline geometry::YarnCurves curvesOf(const fabric::Fabric& fabric, const std::vector<float>& positions) {
    const std::vector<double> diameters(4, kDiameterMm);
    return geometry::buildYarnCurves(fabric, positions, diameters);
}

inline geometry::YarnCurves curvesOf(const fabric::Fabric& fabric) {
    return curvesOf(fabric, relaxedLattice(fabric, kLoopMm));
}

} // namespace knittsim::test
