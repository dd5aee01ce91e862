#pragma once

#include "core/base/result.h"
#include "core/machine/program.h"

#include <filesystem>
#include <string_view>

namespace knittsim::formats::knitout {

/// Errors after which reading stops.
constexpr int kMaxProblems = 20;

/// Reads knitout 2 (textiles-lab/knitout, text of version 0.6). Any bytes are safe.
///
/// Errors and warnings: KS01xx, each with file, line and column; at most kMaxProblems errors. Repeated
/// warnings of one kind (line ends, unknown extensions of one name) are given once.
/// A program is returned only when there is no error; `bad` lines never become operations.
Result<machine::Program> parse(std::string_view text, const std::string& file);

/// readFile + parse.
Result<machine::Program> read(const std::filesystem::path& path);

} // namespace knittsim::formats::knitout
