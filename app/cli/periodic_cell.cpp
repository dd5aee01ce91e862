#include "app/cli/periodic_cell.h"

#include <fmt/core.h>

#include <limits>

namespace knittsim::cli {

void addYarnPhysics(CLI::App& command, std::optional<double>& friction, double& set) {
    command.add_option("--friction", friction, "of yarn on yarn, instead of the yarn's")
        ->check(CLI::Range(0.0, 2.0));
    command.add_option("--set", set, "share of its curvature that the yarn keeps, 1: steamed")
        ->check(CLI::Range(0.0, 1.0))
        ->capture_default_str();
}

physics::YarnRelaxOptions relaxOptions(const PeriodicOptions& options, const Deadline& deadline) {
    physics::YarnRelaxOptions relax;
    relax.residual = options.until;
    relax.cancelled = &deadline.late();
    relax.mostEvaluations = std::numeric_limits<int>::max(); // time is the limit
    if (!options.integrator.empty()) {
        relax.integrator = options.integrator.c_str();
    }
    return relax;
}

std::optional<PeriodicCell> settlePeriodic(const Loaded& loaded, const PeriodicOptions& options,
                                           const Deadline& deadline, int nodesPerLoop) {
    const std::optional<physics::FabricRepeat> found = physics::findFabricRepeat(*loaded.fabric);
    if (!found) {
        fmt::print(stderr, "most of the fabric would have to be knit and purl stitches of one yarn that "
                           "repeat themselves\n");
        return std::nullopt;
    }
    const yarn::Yarn& material = loaded.yarns[found->carrier];
    const physics::YarnUnits units = physics::unitsOf(material);
    std::vector<double> lengths = found->repeat.loopLengths;
    for (double& length : lengths) {
        length /= units.lengthMm;
    }
    physics::CellOptions cellOptions;
    cellOptions.start.nodesPerLoop = nodesPerLoop;
    cellOptions.relax = relaxOptions(options, deadline);
    physics::RodYarn rod = physics::toRod(material, units);
    rod.friction = options.friction.value_or(rod.friction);
    rod.set = options.set;
    if (rod.friction > 0) {
        cellOptions.machine = physics::machineHold(loaded.timeline->profile().pitchMm(), units);
    }
    physics::CellShape cell = physics::relaxCell(found->repeat.pattern, lengths, rod, cellOptions);
    return PeriodicCell{*found, units, rod, std::move(cell)};
}

} // namespace knittsim::cli
