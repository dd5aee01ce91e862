#pragma once

#include "core/base/result.h"
#include "core/yarn/yarn.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace knittsim::yarn {

/// A person's own yarns: a folder of files as in resources/yarns, one yarn a file, to be put under version
/// control as it is.

/// A file name for a yarn: small letters, digits and dashes; "yarn" for a name without any.
std::string idOf(std::string_view name);

/// Writes the yarn to FOLDER/ID.json; the folder is made where there is none. The yarn's id must be one of
/// idOf(). Errors: KS0002.
Diagnostics keepYarn(const std::filesystem::path& folder, const Yarn& yarn);

/// Reads a yarn, or a library of them, from elsewhere and keeps them; one that has the id of another gets a
/// new id, none is replaced. Errors: those of readYarns() and of keepYarn().
Result<std::vector<Yarn>> importYarns(const std::filesystem::path& file, const std::filesystem::path& folder);

/// True where FOLDER has a file of this id.
bool isOwn(const std::filesystem::path& folder, std::string_view id);
void forgetYarn(const std::filesystem::path& folder, std::string_view id);

} // namespace knittsim::yarn
