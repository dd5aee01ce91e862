#pragma once

#include "core/base/diagnostic.h"

#include <string_view>

namespace knittsim {

/// Gives the findings of a JsonReader (KS0004, KS0005) the line of the key that their first argument names,
/// or of the innermost object around it where there is no such key. `text` is the JSON that was read.
void tellLines(std::string_view text, Diagnostics& problems);

} // namespace knittsim
