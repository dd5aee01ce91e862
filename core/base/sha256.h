#pragma once

#include <string>
#include <string_view>

namespace knittsim {

/// SHA-256 (FIPS 180-4) as 64 hexadecimal digits; empty where the cryptographic library fails.
std::string sha256(std::string_view bytes);

} // namespace knittsim
