#pragma once

#include "core/fabric/fabric.h"
#include "core/machine/timeline.h"
#include "core/yarn/yarn.h"

#include <CLI/App.hpp>

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace knittsim::cli {

/// What decides how a file becomes a fabric; shared by the commands that need one.
struct LoadOptions {
    std::string file;
    std::vector<std::string> yarns; ///< CARRIER=ID
    double loopLengthMm = 0;        ///< overrides every stitch size when positive
    int step = -1;                  ///< operations to carry out; all when negative
    bool reduce = false;            ///< takes out the loops that nothing holds
    bool noStitchHolder = false;    ///< with reduce: loops left on needles run as well
};

struct Loaded {
    std::shared_ptr<const machine::Timeline> timeline;
    std::shared_ptr<const fabric::Fabric> fabric;
    std::vector<yarn::Yarn> yarns; ///< by carrier
    std::size_t removedLoops = 0;  ///< by LoadOptions::reduce
};

/// --reduce and --no-stitch-holder.
void addReduction(CLI::App& command, LoadOptions& options);

/// What a picture or an export may choose: --step, --yarn, --loop-length and the reduction.
void addFabric(CLI::App& command, LoadOptions& options);

/// Prints diagnostics to stderr. Returns nothing when the file or an option cannot be used.
std::shared_ptr<const machine::Timeline> loadTimeline(const LoadOptions& options);
std::optional<Loaded> load(const LoadOptions& options);

} // namespace knittsim::cli
