#pragma once

#include "app/cli/load.h"

namespace knittsim::cli {

struct PeriodicOptions {
    std::string integrator; ///< the fastest when empty
    double until = 1e-3;    ///< residual
    double maxSeconds = 60;
    bool json = false;
};

/// Settles the repeat of a fabric as a periodic cell of the yarn model and prints what it measures. Returns
/// an exit code.
int relaxPeriodic(const Loaded& loaded, const PeriodicOptions& options);

} // namespace knittsim::cli
