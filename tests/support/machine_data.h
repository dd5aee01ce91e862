#pragma once

#include <cstdlib>
#include <filesystem>

namespace knittsim::test {

/// Programs knitted on real machines, which are not part of the project: $KNITTSIM_MACHINE_DATA, else
/// shared/machine-data beside the source tree.
inline std::filesystem::path machineData() {
    const char* folder = std::getenv("KNITTSIM_MACHINE_DATA");
    return folder != nullptr
               ? std::filesystem::path(folder)
               : std::filesystem::path(KNITTSIM_SOURCE_DIR).parent_path() / "shared" / "machine-data";
}

} // namespace knittsim::test
