#include "app/cli/settle.h"

#include "app/cli/deadline.h"
#include "app/cli/relax_fabric.h"
#include "core/simulation/simulation.h"
#include "core/simulation/yarn_settling.h"

#include <fmt/core.h>

#include <cstdio>

namespace knittsim::cli {

namespace {

Settled settledPoints(const Loaded& loaded, double maxSeconds) {
    simulation::Simulation simulation;
    simulation.apply(
        simulation::command::Load{.fabric = loaded.fabric, .yarns = loaded.yarns, .generation = 1});
    simulation.apply(simulation::command::Start{});
    simulation.runToEnd(maxSeconds);
    simulation::Frame frame = simulation.frame();
    return {.places = std::move(frame.positions), .tension = std::move(frame.tension)};
}

/// The yarn model at rest.
std::optional<Settled> settledYarn(const Loaded& loaded, const SettleOptions& options) {
    const Deadline deadline(options.maxSeconds);
    simulation::YarnSettling settling(*loaded.fabric, loaded.yarns,
                                      {.surroundings = surroundingsOf(options.surroundings)});
    if (*settling.problem() != '\0') {
        fmt::print(stderr, "--relax yarn: {}\n", settling.problem());
        return std::nullopt;
    }
    while (settling.step(physics::Interrupt(&deadline.late()))) {
    }
    simulation::YarnPicture picture = settling.picture();
    return Settled{simulation::entryPositions(*loaded.fabric, settling.yarns(), settling.shape()),
                   std::move(picture.curves), std::move(picture.tension), std::move(picture.contact)};
}

} // namespace

void addSettling(CLI::App& command, SettleOptions& options) {
    command.add_option("--relax", options.relax, "settle first")
        ->check(CLI::IsMember({"none", "bonding-points", "yarn"}))
        ->capture_default_str();
    command.add_option("--max-seconds", options.maxSeconds, "time limit of settling")
        ->check(CLI::Range(0.0, 1e6))
        ->capture_default_str();
    addSurroundings(command, options.surroundings);
}

std::optional<Settled> settle(const Loaded& loaded, const SettleOptions& options) {
    if (options.relax != "yarn" && !options.surroundings.empty()) {
        fmt::print(stderr, "--surroundings needs --relax yarn\n");
        return std::nullopt;
    }
    if (options.relax == "yarn") {
        return settledYarn(loaded, options);
    }
    if (options.relax == "bonding-points") {
        return settledPoints(loaded, options.maxSeconds);
    }
    return Settled{};
}

} // namespace knittsim::cli
