#pragma once

#include "app/cli/deadline.h"
#include "app/cli/load.h"
#include "core/simulation/fabric_cell.h"

#include <CLI/App.hpp>

#include <optional>
#include <string>

namespace knittsim::cli {

struct PeriodicOptions {
    std::string integrator; ///< the fastest when empty
    double until = 1e-3;    ///< residual
    double maxSeconds = 60;
    std::optional<double> friction; ///< instead of the yarn's; 0: the cell settles without a history
    double set = 0;                 ///< share of its curvature that the yarn keeps
};

/// --friction and --set.
void addYarnPhysics(CLI::App& command, std::optional<double>& friction, double& set);

/// Solver, residual and deadline as the options say; `options` and `deadline` must outlive the result.
physics::YarnRelaxOptions relaxOptions(const PeriodicOptions& options, const Deadline& deadline);

/// Says on stderr why when there is no repeat.
std::optional<simulation::FabricCell> settlePeriodic(const Loaded& loaded, const PeriodicOptions& options,
                                                     const Deadline& deadline, int nodesPerLoop = 24);

} // namespace knittsim::cli
