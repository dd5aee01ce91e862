#pragma once

#include "app/cli/periodic_cell.h"

namespace knittsim::cli {

/// Settles the repeat of a fabric as a periodic cell of the yarn model and prints what it measures, as text
/// or JSON. Returns an exit code.
int relaxPeriodic(const Loaded& loaded, const PeriodicOptions& options, bool json);

} // namespace knittsim::cli
