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
    std::string surroundings; ///< of the yarn model; empty: not given
};

/// --relax, --max-seconds and --surroundings.
void addSettling(CLI::App& command, SettleOptions& options);

struct Settled {
    std::vector<float> places;                    ///< 3 per entry, mm; empty: where the machine leaves them
    std::optional<geometry::YarnCurves> curves{}; ///< of the yarn model
    /// As the colour of a picture may tell them (render::PictureRequest::values): of the curves, or of the
    /// bonding points. Empty where there are none.
    std::vector<float> tension{}; ///< mN
    std::vector<float> contact{}; ///< mN/mm of yarn
};

/// Nothing, and said on stderr, when the fabric cannot be settled so.
std::optional<Settled> settle(const Loaded& loaded, const SettleOptions& options);

} // namespace knittsim::cli
