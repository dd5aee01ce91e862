#pragma once

#include <filesystem>

namespace knittsim {

/// Folder with yarns/, machines/, patterns/, shaders/: $KNITTSIM_RESOURCES, else share/knittsim beside the
/// program's folder, else the source tree the program was built from.
std::filesystem::path resourceFolder();

/// What an environment variable says; empty without it.
std::filesystem::path folderFrom(const char* variable);

/// The user's own folder: $XDG_CONFIG_HOME/knittsim, else ~/.config/knittsim (XDG Base Directory
/// Specification); empty where neither is known.
std::filesystem::path userFolder();

} // namespace knittsim
