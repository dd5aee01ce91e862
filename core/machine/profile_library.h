#pragma once

#include "core/machine/profile.h"
#include "core/machine/program.h"

#include <filesystem>
#include <string_view>
#include <vector>

namespace knittsim::machine {

/// The machine profiles that a user can choose from. Immutable once read.
class ProfileLibrary {
public:
    /// Reads all *.json files of the folders but not *.schema.json; a later profile replaces an earlier one
    /// of the same id. A folder that does not exist is empty. A file with faults is left out and its
    /// errors go to `problems`. The generic profile is always there.
    static ProfileLibrary read(const std::vector<std::filesystem::path>& folders, Diagnostics& problems);

    /// By id.
    const std::vector<MachineProfile>& profiles() const { return m_profiles; }

    /// The profile with this id, or nullptr.
    const MachineProfile* find(std::string_view id) const;

    /// The profile that ';;Machine:' means, by id or by the names a profile gives; capitals do not matter.
    const MachineProfile* findMachine(std::string_view machine) const;

private:
    std::vector<MachineProfile> m_profiles;
};

/// The user's own: the folder $KNITTSIM_MACHINES, else knittsim/machines in $XDG_CONFIG_HOME or ~/.config;
/// empty where none of them is set.
std::filesystem::path userProfileFolder();

/// resources/machines, then the user's own.
std::vector<std::filesystem::path> profileFolders();

/// Copies a profile that is without fault into `folder` as ID.json, which is made where it is missing; one of
/// the same id is replaced. Errors: those of readMachineProfile() and waiversOf(), KS0002, KS0004 for an id
/// that cannot be a file name.
Result<MachineProfile> addProfile(const std::filesystem::path& path, const std::filesystem::path& folder);

/// The machine a program is emulated on: `wanted` (an id) where it is not empty, else what ';;Machine:'
/// names, else the generic one. Where ';;Gauge:' names another gauge, loops and bed gap change in proportion.
/// Error: KS0008 for an unknown `wanted`. Warning: KS0242 for a machine without profile.
Result<MachineProfile> chooseProfile(const Program& program, const ProfileLibrary& library,
                                     const std::string& wanted = {});

} // namespace knittsim::machine
