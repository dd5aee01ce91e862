#pragma once

#include "core/formats/problems.h"
#include "core/formats/sintral/command.h"

#include <string_view>

namespace knittsim::formats::sintral {

/// Turns the text of a line behind its number into commands; false, and an error with the word that is wrong,
/// when it cannot. `column` is the 1-based column of `text` in the line.
bool parseCommands(std::string_view text, int column, Line& line, Problems& problems);

} // namespace knittsim::formats::sintral
