#pragma once

#include "core/base/result.h"
#include "core/pattern/catalogue.h"

#include <filesystem>
#include <string>
#include <vector>

/// Modules that a person saved: one project file (project.h) each in a folder of their own, named as the
/// file.
namespace knittsim::pattern {

/// $KNITTSIM_MODULES, else knittsim/modules in the person's folder of settings; empty where there is none.
std::filesystem::path ownModuleFolder();

/// By name. Files that cannot be used are left out and told: errors of readProjectFile() as warnings.
std::vector<Module> readOwnModules(const std::filesystem::path& folder, Diagnostics& problems);

/// The name must do as a name of a file: letters, digits, blanks and some signs. Errors: KS0516 for another
/// name or one that is taken, KS0002.
Diagnostics saveOwnModule(const std::filesystem::path& folder, const std::string& name, const Chart& part);
/// Errors: as above.
Diagnostics renameOwnModule(const std::filesystem::path& folder, const std::string& name,
                            const std::string& newName);
/// Errors: KS0002.
Diagnostics removeOwnModule(const std::filesystem::path& folder, const std::string& name);

} // namespace knittsim::pattern
