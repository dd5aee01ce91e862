#include "core/pattern/own_modules.h"

#include "core/base/file.h"
#include "core/base/resources.h"
#include "core/pattern/project.h"

#include <algorithm>
#include <string_view>
#include <system_error>

namespace knittsim::pattern {

namespace {

constexpr std::size_t kMostLetters = 60;

std::filesystem::path fileOf(const std::filesystem::path& folder, const std::string& name) {
    return folder / (name + std::string(kProjectExtension));
}

Diagnostics problem(const std::string& name, const std::string& reason) {
    return {{"KS0516", Severity::Error, {}, {name, reason}}};
}

/// Of a new module; nothing where it can be used.
Diagnostics checkName(const std::filesystem::path& folder, const std::string& name) {
    const bool plain = std::ranges::all_of(name, [](unsigned char c) {
        return c >= 0x20 && c != 0x7f &&
               std::string_view("/\\:*?\"<>|").find(static_cast<char>(c)) == std::string_view::npos;
    });
    if (name.empty() || name.size() > kMostLetters || name.front() == '.' || name.front() == ' ' ||
        name.back() == ' ' || !plain) {
        return problem(name, "it cannot be the name of a file");
    }
    std::error_code ignored;
    return std::filesystem::exists(fileOf(folder, name), ignored) ? problem(name, "there is one already")
                                                                  : Diagnostics{};
}

Diagnostics cannotWrite(const std::filesystem::path& path, const std::error_code& error) {
    return {{"KS0002", Severity::Error, Place{.file = path.string()}, {error.message()}}};
}

} // namespace

std::filesystem::path ownModuleFolder() {
    if (auto own = folderFrom("KNITTSIM_MODULES"); !own.empty()) {
        return own;
    }
    const auto settings = folderFrom("KNITTSIM_CONFIG_DIR");
    const auto user = settings.empty() ? userFolder() : settings;
    return user.empty() ? user : user / "modules";
}

std::vector<Module> readOwnModules(const std::filesystem::path& folder, Diagnostics& problems) {
    std::vector<Module> modules;
    std::error_code ignored; // no folder: no modules
    for (std::filesystem::directory_iterator entry(folder, ignored), end; !ignored && entry != end;
         entry.increment(ignored)) {
        if (!isProjectFile(entry->path())) {
            continue;
        }
        Result<Project> project = readProjectFile(entry->path());
        if (!project) {
            for (Diagnostic found : project.diagnostics()) {
                found.severity = Severity::Warning;
                problems.push_back(std::move(found));
            }
            continue;
        }
        const std::string name = entry->path().stem().string();
        modules.push_back({"own/" + name, name, ModuleGroup::Texture, std::move(project).value().chart});
    }
    std::ranges::sort(modules, {}, &Module::name);
    return modules;
}

Diagnostics saveOwnModule(const std::filesystem::path& folder, const std::string& name, const Chart& part) {
    if (Diagnostics problems = checkName(folder, name); !problems.empty()) {
        return problems;
    }
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error) {
        return cannotWrite(folder, error);
    }
    return writeFileAtomically(fileOf(folder, name), writeProject({.chart = part, .machine = {}}))
        .diagnostics();
}

Diagnostics renameOwnModule(const std::filesystem::path& folder, const std::string& name,
                            const std::string& newName) {
    if (Diagnostics problems = checkName(folder, newName); !problems.empty()) {
        return problems;
    }
    std::error_code error;
    std::filesystem::rename(fileOf(folder, name), fileOf(folder, newName), error);
    return error ? cannotWrite(fileOf(folder, newName), error) : Diagnostics{};
}

Diagnostics removeOwnModule(const std::filesystem::path& folder, const std::string& name) {
    std::error_code error;
    std::filesystem::remove(fileOf(folder, name), error);
    return error ? cannotWrite(fileOf(folder, name), error) : Diagnostics{};
}

} // namespace knittsim::pattern
