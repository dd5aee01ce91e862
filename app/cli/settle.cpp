#include "app/cli/settle.h"

#include "app/cli/deadline.h"
#include "core/simulation/simulation.h"
#include "core/simulation/yarn_settling.h"

#include <fmt/core.h>

#include <cstdio>

namespace knittsim::cli {

namespace {

std::vector<float> settledPositions(const Loaded& loaded, double maxSeconds) {
    simulation::Simulation simulation;
    simulation.apply(
        simulation::command::Load{.fabric = loaded.fabric, .yarns = loaded.yarns, .generation = 1});
    simulation.apply(simulation::command::Start{});
    simulation.runToEnd(maxSeconds);
    return simulation.frame().positions;
}

/// The yarn model at rest on a table.
std::optional<Settled> settledYarn(const Loaded& loaded, double maxSeconds) {
    const Deadline deadline(maxSeconds);
    simulation::YarnSettling settling(*loaded.fabric, loaded.yarns, {});
    if (*settling.problem() != '\0') {
        fmt::print(stderr, "--relax yarn: {}\n", settling.problem());
        return std::nullopt;
    }
    while (settling.step(physics::Interrupt(&deadline.late()))) {
    }
    return Settled{simulation::entryPositions(*loaded.fabric, settling.yarns(), settling.shape()),
                   settling.curves()};
}

} // namespace

void addSettling(CLI::App& command, SettleOptions& options) {
    command.add_option("--relax", options.relax, "settle first")
        ->check(CLI::IsMember({"none", "bonding-points", "yarn"}))
        ->capture_default_str();
    command.add_option("--max-seconds", options.maxSeconds, "time limit of settling")
        ->check(CLI::Range(0.0, 1e6))
        ->capture_default_str();
}

std::optional<Settled> settle(const Loaded& loaded, const SettleOptions& options) {
    if (options.relax == "yarn") {
        return settledYarn(loaded, options.maxSeconds);
    }
    if (options.relax == "bonding-points") {
        return Settled{settledPositions(loaded, options.maxSeconds)};
    }
    return Settled{};
}

} // namespace knittsim::cli
