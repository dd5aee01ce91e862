#pragma once

#include "app/cli/load.h"
#include "core/geometry/yarn_curve.h"

#include <CLI/App.hpp>

#include <optional>
#include <string>
#include <vector>

namespace knittsim::cli {

/// How a fabric is settled before it is drawn or exported.
struct SettleOptions {
    std::string relax = "bonding-points";
    double maxSeconds = 60;
};

/// --relax and --max-seconds.
void addSettling(CLI::App& command, SettleOptions& options);

struct Settled {
    std::vector<float> places;                    ///< 3 per entry, mm; empty: where the machine leaves them
    std::optional<geometry::YarnCurves> curves{}; ///< of the yarn model
};

/// Nothing, and said on stderr, when the fabric cannot be settled so.
std::optional<Settled> settle(const Loaded& loaded, const SettleOptions& options);

} // namespace knittsim::cli
