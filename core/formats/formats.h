#pragma once

#include "core/base/result.h"
#include "core/machine/program.h"

#include <filesystem>
#include <string>

namespace knittsim::formats {

/// Reads machine data of any known format: knitout, Shima DAT, Kniterate k-code, Stoll Sintral with the .jac
/// file of the same name beside it. The format is told from the first bytes, then from the extension.
/// Errors: KS0001, KS0006, KS0007, KS0020 and those of the reader.
Result<machine::Program> readProgram(const std::filesystem::path& path);

/// The bytes of a file with the program; the extension of `path` chooses the format: .k and .knitout, .dat,
/// .kc. Nothing is written. Errors: KS0021 for other extensions and those of the writer.
Result<std::string> writeProgram(const machine::Program& program, const std::filesystem::path& path);

} // namespace knittsim::formats
