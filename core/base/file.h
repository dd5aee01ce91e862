#pragma once

#include "core/base/result.h"

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace knittsim {

/// Largest machine file that is read. 100,000 operations take about 2 MB.
constexpr std::size_t kMaxFileBytes = std::size_t{32} << 20;

/// Reads a whole file. Errors: KS0001, KS0007 (checked before memory is taken and, for what has no size
/// beforehand, while reading).
Result<std::string> readFile(const std::filesystem::path& path, std::size_t maxBytes = kMaxFileBytes);

/// ".PNG" -> ".png"; empty without one.
std::string lowerExtension(const std::filesystem::path& path);

/// The *.json files of a folder by name, without *.schema.json; empty where there is no such folder.
std::vector<std::filesystem::path> jsonFiles(const std::filesystem::path& folder);

struct Written {};

/// Writes to a temporary file beside `path` and renames it, so that `path` is never half written.
/// Errors: KS0002; the temporary file is removed then.
Result<Written> writeFileAtomically(const std::filesystem::path& path, std::string_view bytes);

} // namespace knittsim
