#pragma once

#include "app/cli/load.h"
#include "core/geometry/measure.h"
#include "core/simulation/surroundings.h"

#include <CLI/App.hpp>

namespace knittsim::cli {

struct FabricYarnOptions {
    std::string integrator; ///< the default of the yarn model when empty
    std::string state;      ///< file to write the shape to; none when empty
    double until = 1e-3;    ///< residual
    double maxSeconds = 60;
    std::optional<geometry::Region> region; ///< to measure; the inner part when there is none
    simulation::Surroundings surroundings = simulation::Surroundings::Flat;
    bool json = false;
};

/// --surroundings; empty: not given.
void addSurroundings(CLI::App& command, std::string& id);
/// Flat where the id is empty.
simulation::Surroundings surroundingsOf(const std::string& id);

/// Settles a whole fabric in the yarn model, measures and audits it and prints that. Returns an exit code.
int relaxFabric(const Loaded& loaded, const FabricYarnOptions& options);

/// Writes positions (3 per entry of the bonding point table, mm) as the state of a fabric.
bool writeState(const std::string& path, const Loaded& loaded, std::span<const float> positions);

/// The part of a fabric that its edges do not reach: wales and courses without a sixth on every side.
geometry::Region innerRegion(const fabric::Fabric& fabric, std::span<const float> positions);

} // namespace knittsim::cli
