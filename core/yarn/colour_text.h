#pragma once

#include "core/yarn/yarn.h"

namespace knittsim {
class JsonReader;
}

namespace knittsim::yarn {

/// "#rrggbb"
std::string colourText(Colour colour);

/// The colour at the key `colour`. Errors go to the reader: KS0004, KS0005; then grey.
Colour readColour(JsonReader& reader);

} // namespace knittsim::yarn
