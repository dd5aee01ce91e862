#include "core/machine/profile_library.h"

#include "core/base/file.h"
#include "core/base/resources.h"
#include "core/machine/checks/check.h"

#include <algorithm>
#include <cctype>

namespace knittsim::machine {

namespace {

std::string lower(std::string_view text) {
    std::string result(text);
    std::ranges::transform(result, result.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return result;
}

bool matches(const std::string& machine, std::string_view name) {
    const std::string pattern = lower(name);
    return pattern.ends_with('*') ? machine.starts_with(pattern.substr(0, pattern.size() - 1))
                                  : machine == pattern;
}

void takeGauge(double gauge, MachineProfile& profile) {
    const double scale = profile.gauge / gauge;
    profile.gauge = gauge;
    profile.bedGapMm *= scale;
    profile.defaultLoopLengthMm *= scale;
    for (auto& [number, length] : profile.stitchTable) {
        length *= scale;
    }
}

std::string idsOf(const ProfileLibrary& library) {
    std::string ids;
    for (const MachineProfile& profile : library.profiles()) {
        ids += (ids.empty() ? "" : ", ") + profile.id;
    }
    return ids;
}

} // namespace

ProfileLibrary ProfileLibrary::read(const std::vector<std::filesystem::path>& folders,
                                    Diagnostics& problems) {
    ProfileLibrary library;
    library.m_profiles.push_back(genericProfile());
    for (const std::filesystem::path& folder : folders) {
        for (const std::filesystem::path& file : jsonFiles(folder)) {
            Result<MachineProfile> profile = readMachineProfile(file);
            problems.insert(problems.end(), profile.diagnostics().begin(), profile.diagnostics().end());
            if (!profile) {
                continue;
            }
            std::erase_if(library.m_profiles, [&](const auto& old) { return old.id == profile->id; });
            library.m_profiles.push_back(std::move(profile).value());
        }
    }
    std::ranges::sort(library.m_profiles, {}, &MachineProfile::id);
    return library;
}

const MachineProfile* ProfileLibrary::find(std::string_view id) const {
    const auto found = std::ranges::find(m_profiles, id, &MachineProfile::id);
    return found == m_profiles.end() ? nullptr : &*found;
}

const MachineProfile* ProfileLibrary::findMachine(std::string_view machine) const {
    const std::string wanted = lower(machine);
    const auto byId = std::ranges::find_if(m_profiles, [&](const auto& p) { return lower(p.id) == wanted; });
    if (byId != m_profiles.end()) {
        return &*byId;
    }
    const auto byName = std::ranges::find_if(m_profiles, [&](const MachineProfile& profile) {
        return std::ranges::any_of(profile.machineNames,
                                   [&](const std::string& name) { return matches(wanted, name); });
    });
    return byName == m_profiles.end() ? nullptr : &*byName;
}

std::filesystem::path userProfileFolder() {
    if (auto own = folderFrom("KNITTSIM_MACHINES"); !own.empty()) {
        return own;
    }
    const auto user = userFolder();
    return user.empty() ? user : user / "machines";
}

std::vector<std::filesystem::path> profileFolders() {
    std::vector<std::filesystem::path> folders{resourceFolder() / "machines"};
    if (const auto own = userProfileFolder(); !own.empty()) {
        folders.push_back(own);
    }
    return folders;
}

Result<MachineProfile> addProfile(const std::filesystem::path& path, const std::filesystem::path& folder) {
    Result<MachineProfile> profile = readMachineProfile(path);
    if (!profile) {
        return profile;
    }
    const std::string& id = profile->id;
    const bool isName = id.front() != '.' && std::ranges::all_of(id, [](unsigned char c) {
                            return std::isalnum(c) != 0 || c == '-' || c == '_' || c == '.';
                        });
    if (!isName) {
        return Diagnostic{"KS0004",
                          Severity::Error,
                          Place{.file = path.string()},
                          {"id", '"' + id + '"', "letters, digits, '-', '_' and '.'"}};
    }
    if (const auto off = waiversOf(profile.value()); !off) {
        return Result<MachineProfile>::failure(off.diagnostics());
    }
    const Result<std::string> bytes = readFile(path);
    if (!bytes) {
        return Result<MachineProfile>::failure(bytes.diagnostics());
    }
    std::error_code code;
    std::filesystem::create_directories(folder, code);
    if (const auto written = writeFileAtomically(folder / (id + ".json"), bytes.value()); !written) {
        return Result<MachineProfile>::failure(written.diagnostics());
    }
    return profile;
}

Result<MachineProfile> chooseProfile(const Program& program, const ProfileLibrary& library,
                                     const std::string& wanted) {
    const Header& header = program.header;
    Diagnostics diagnostics;
    const MachineProfile* found = nullptr;
    if (!wanted.empty()) {
        found = library.find(wanted);
        if (found == nullptr) {
            return Diagnostic{"KS0008", Severity::Error, {}, {"machine profile", wanted, idsOf(library)}};
        }
    } else if (!header.machine.empty()) {
        found = library.findMachine(header.machine);
    }
    MachineProfile profile = found != nullptr ? *found : *library.find(genericProfile().id);
    if (found == nullptr && !header.machine.empty()) {
        diagnostics.push_back(
            {"KS0242", Severity::Warning, Place{.file = program.file}, {header.machine, profile.name}});
    }
    if (header.gauge && *header.gauge > 0 && *header.gauge != profile.gauge) {
        takeGauge(*header.gauge, profile);
    }
    return {std::move(profile), std::move(diagnostics)};
}

} // namespace knittsim::machine
