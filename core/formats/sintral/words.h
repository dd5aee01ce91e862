#pragma once

#include "core/formats/text.h"

#include <string_view>

namespace knittsim::formats::sintral {

constexpr int kMaxSmallNumber = 99'999; ///< line numbers, needles, counters, repeats

constexpr bool isDigit(char c) {
    return c >= '0' && c <= '9';
}

/// May stand in a jacquard.
constexpr bool isSymbol(char c) {
    return (c >= 'A' && c <= 'Z') || c == '.' || c == '*' || c == '+';
}

/// A number written with digits only, -1 for anything else and for more than kMaxSmallNumber.
inline int smallNumber(std::string_view text) {
    if (text.empty() || !isDigit(text[0])) {
        return -1;
    }
    const auto number = parseInteger(text);
    return number && *number <= kMaxSmallNumber ? static_cast<int>(*number) : -1;
}

/// Takes `prefix` away from the beginning of `text`, if it is there.
inline bool takePrefix(std::string_view& text, std::string_view prefix) {
    if (text.substr(0, prefix.size()) != prefix) {
        return false;
    }
    text.remove_prefix(prefix.size());
    return true;
}

/// The text before the first `separator`, which is taken from `text` together with it.
inline std::string_view takePart(std::string_view& text, char separator) {
    const std::size_t end = text.find(separator);
    const std::string_view part = text.substr(0, end);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    return part;
}

} // namespace knittsim::formats::sintral
