#include "core/base/resources.h"

#include <cstdlib>

namespace knittsim {

std::filesystem::path resourceFolder() {
    if (auto folder = folderFrom("KNITTSIM_RESOURCES"); !folder.empty()) {
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

std::filesystem::path folderFrom(const char* variable) {
    const char* value = std::getenv(variable);
    return value == nullptr ? "" : value;
}

std::filesystem::path userFolder() {
    if (const auto config = folderFrom("XDG_CONFIG_HOME"); !config.empty()) {
        return config / "knittsim";
    }
    const auto home = folderFrom("HOME");
    return home.empty() ? home : home / ".config" / "knittsim";
}

} // namespace knittsim
