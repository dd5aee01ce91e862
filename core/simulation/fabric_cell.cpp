#include "core/simulation/fabric_cell.h"

#include <fmt/format.h>

#include <cmath>

namespace knittsim::simulation {

FabricCell settleCell(const fabric::Fabric& fabric, const physics::FabricRepeat& found,
                      std::span<const yarn::Yarn> yarns, const FabricCellOptions& options) {
    const yarn::Yarn material = found.carrier < yarns.size() ? yarns[found.carrier] : yarn::Yarn();
    const physics::YarnUnits units = physics::unitsOf(material);
    std::vector<double> lengths = found.repeat.loopLengths;
    for (double& length : lengths) {
        length /= units.lengthMm;
    }
    physics::CellOptions cellOptions;
    cellOptions.start.nodesPerLoop = options.nodesPerLoop;
    cellOptions.relax = options.relax;
    physics::RodYarn rod = physics::toRod(material, units);
    rod.friction = options.friction.value_or(rod.friction);
    rod.set = options.set;
    if (rod.friction > 0) {
        cellOptions.machine = physics::machineHold(fabric.pitchMm, units);
    }
    physics::CellShape cell = physics::relaxCell(found.repeat.pattern, lengths, rod, cellOptions);
    return {found, units, rod, std::move(cell)};
}

double stressUnit(const physics::YarnUnits& units) {
    return units.bendingStiffness / std::pow(units.lengthMm, 3) * 1e-3;
}

std::string pullCsv(std::span<const physics::PullPoint> points, const physics::YarnUnits& units) {
    std::string text = "strain,stress_n_per_mm,width_mm,height_mm,back\n";
    for (const physics::PullPoint& p : points) {
        text += fmt::format("{:.5f},{:.6f},{:.4f},{:.4f},{}\n", p.strain, p.stress * stressUnit(units),
                            p.width * units.lengthMm, p.height * units.lengthMm, p.back ? 1 : 0);
    }
    return text;
}

} // namespace knittsim::simulation
