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

std::optional<simulation::FabricCell> settlePeriodic(const Loaded& loaded, const PeriodicOptions& options,
                                                     const Deadline& deadline, int nodesPerLoop) {
    const std::optional<physics::FabricRepeat> found = physics::findFabricRepeat(*loaded.fabric);
    if (!found) {
        fmt::print(stderr, "most of the fabric would have to be knit and purl stitches of one yarn that "
                           "repeat themselves\n");
        return std::nullopt;
    }
    return simulation::settleCell(*loaded.fabric, *found, loaded.yarns,
                                  {.friction = options.friction,
                                   .set = options.set,
                                   .nodesPerLoop = nodesPerLoop,
                                   .relax = relaxOptions(options, deadline)});
}

} // namespace knittsim::cli
