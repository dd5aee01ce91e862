#include "core/yarn/colour_text.h"

#include "core/base/json_reader.h"

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <string_view>

namespace knittsim::yarn {

namespace {

int hexDigit(char c) {
    constexpr std::string_view kDigits = "0123456789abcdef";
    const std::size_t found = kDigits.find(c >= 'A' && c <= 'F' ? static_cast<char>(c - 'A' + 'a') : c);
    return found == std::string_view::npos ? -1 : static_cast<int>(found);
}

} // namespace

std::string colourText(Colour colour) {
    return fmt::format("#{:02x}{:02x}{:02x}", colour.r, colour.g, colour.b);
}

Colour readColour(JsonReader& reader) {
    const std::string text = reader.text("colour");
    std::array<int, 3> rgb{};
    bool good = text.size() == 7 && text[0] == '#';
    for (std::size_t i = 0; good && i < rgb.size(); ++i) {
        const int high = hexDigit(text[1 + 2 * i]);
        const int low = hexDigit(text[2 + 2 * i]);
        good = high >= 0 && low >= 0;
        rgb[i] = 16 * high + low;
    }
    if (!good) {
        if (!text.empty()) {
            reader.report("colour", '"' + text + '"', "a colour such as #a1b2c3");
        }
        return {};
    }
    return {static_cast<std::uint8_t>(rgb[0]), static_cast<std::uint8_t>(rgb[1]),
            static_cast<std::uint8_t>(rgb[2])};
}

} // namespace knittsim::yarn
