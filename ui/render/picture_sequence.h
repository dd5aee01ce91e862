#pragma once

#include "core/simulation/settling_record.h"
#include "ui/render/offscreen.h"

#include <filesystem>

namespace knittsim::render {

/// Numbered pictures (0001.png, 0002.png, ...) of shapes of one fabric in a new folder, all seen with one
/// camera: that of `look`, else one that sees the largest shape whole. `look` tells everything but shape and
/// values. The folder gets its name when all is written: it is there as a whole or not at all. Errors: KS0002
/// (also where the folder exists), KS0009 (cancelled), and those of renderFabric().
Result<Written> writeSequence(const std::filesystem::path& folder, const RenderRequest& look,
                              std::span<const simulation::SettlingShape> shapes,
                              const Progress& progress = {});

} // namespace knittsim::render
