#pragma once

#include "core/base/diagnostic.h"

#include <optional>
#include <string>
#include <string_view>

namespace knittsim {

/// The text without a byte order mark of UTF-8.
std::string_view withoutByteOrderMark(std::string_view text);

/// Why these bytes cannot be read as text in UTF-8 at all, in one finding: KS0012 empty, KS0013 another
/// encoding, KS0122 a NUL byte, KS0014 too many control characters. Nothing for text, broken characters
/// included. Linear in time.
std::optional<Diagnostic> whyNotText(std::string_view bytes, const std::string& file);

} // namespace knittsim
