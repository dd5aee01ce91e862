#include "core/base/resources.h"

#include <cstdlib>

namespace knittsim {

std::filesystem::path resourceFolder() {
    if (const char* folder = std::getenv("KNITTSIM_RESOURCES"); folder != nullptr && *folder != '\0') {
        return folder;
    }
    std::error_code error;
    const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", error);
    if (!error) {
        const auto installed = program.parent_path().parent_path() / "share" / "knittsim";
        if (std::filesystem::is_directory(installed, error)) {
            return installed;
        }
    }
    return KNITTSIM_SOURCE_RESOURCES;
}

} // namespace knittsim
