#pragma once

#include "core/base/result.h"
#include "core/formats/problems.h"
#include "core/machine/program.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace knittsim::formats::knitout {

/// Errors after which reading stops.
constexpr int kMaxProblems = kMaxErrors;

/// Reads knitout 2 (textiles-lab/knitout, text of version 0.6). Any bytes are safe; time is linear in their
/// number.
///
/// Errors and warnings: KS01xx, each with file, line and column; at most kMaxProblems errors. Repeated
/// warnings of one kind (line ends, unknown extensions of one name) are given once.
/// A program is returned only when there is no error; `bad` lines never become operations.
///
/// Knit, tuck and split without carriers become Drop, Amiss and Xfer. A fault in an extension ('x-...') is a
/// warning, and the operation is kept as Extension. Comments ';!source:...' are kept whole, from the ';' on,
/// with the operation of their line or else the next one (operations.size() after the last). In lines that
/// are not UTF-8 each broken byte becomes '?'. Colours are kept as "#rrggbb" in small letters, the text of
/// `pause` as it is.
Result<machine::Program> parse(std::string_view text, const std::string& file);

/// readFile + parse.
Result<machine::Program> read(const std::filesystem::path& path);

} // namespace knittsim::formats::knitout
