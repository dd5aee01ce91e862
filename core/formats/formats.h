#pragma once

#include "core/base/result.h"
#include "core/machine/program.h"

#include <filesystem>

namespace knittsim::formats {

/// Reads machine data of any known format; the format is told from the name and the first bytes.
/// Errors: KS0001, KS0006, KS0007 and those of the reader.
Result<machine::Program> readProgram(const std::filesystem::path& path);

} // namespace knittsim::formats
