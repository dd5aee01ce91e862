#pragma once

#include <filesystem>

namespace knittsim {

/// Folder with yarns/, machines/, patterns/, shaders/: $KNITTSIM_RESOURCES, else share/knittsim beside the
/// program's folder, else the source tree the program was built from.
std::filesystem::path resourceFolder();

} // namespace knittsim
