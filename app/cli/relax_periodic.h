#pragma once

#include "app/cli/load.h"

namespace knittsim::cli {

struct PeriodicOptions {
    std::string integrator; ///< the fastest when empty
    double until = 1e-3;    ///< residual
    double maxSeconds = 60;
    bool json = false;
    std::optional<double> friction; ///< instead of the yarn's; 0: the cell settles without a history
    double set = 0;                 ///< share of its curvature that the yarn keeps
};

/// Settles the repeat of a fabric as a periodic cell of the yarn model and prints what it measures. Returns
/// an exit code.
int relaxPeriodic(const Loaded& loaded, const PeriodicOptions& options);

} // namespace knittsim::cli
