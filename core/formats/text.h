#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace knittsim::formats {

/// Longest piece of a file that a diagnostic shows, bytes.
constexpr std::size_t kShownBytes = 60;

/// Text of a file as a person may see it: at most kShownBytes (then "..."), valid UTF-8, every control or
/// direction-changing character and every broken byte replaced by '?'.
std::string shown(std::string_view text);

/// shown() between single quotes, or "nothing" for an empty text.
std::string quoted(std::string_view text);

bool isUtf8(std::string_view text);

/// The same bytes with '?' for each byte that is not part of valid UTF-8, so that columns stay the same.
std::string replaceBadUtf8(std::string_view text);

/// Byte offset of the first typographic minus or dash that looks like '-', or nothing.
std::optional<std::size_t> findTypographicMinus(std::string_view text);

/// A carriage return that ends no line counts as a blank.
constexpr bool isBlank(char c) {
    return c == ' ' || c == '\t' || c == '\r';
}

/// Without blanks at both ends.
std::string_view trim(std::string_view text);

/// A word of a line. `column` is the 1-based byte column; the token after the last word is empty.
struct Token {
    std::string_view text;
    int column = 1;
};

/// Words of a line, separated by blanks.
class Tokens {
public:
    explicit Tokens(std::string_view line) : m_line(line) {}

    Token next();
    Token peek() const { return Tokens(*this).next(); }

    /// What is left of the line, trimmed.
    std::string_view rest() const { return trim(m_line.substr(m_at)); }

    void skipAll() { m_at = m_line.size(); }

private:
    std::string_view m_line;
    std::size_t m_at = 0;
};

/// A whole decimal number with an optional sign, or nothing. A number too large or too small for the type is
/// infinite or the largest of its type, so that a range check refuses it. Never NaN, never -0.
std::optional<double> parseNumber(std::string_view text);
std::optional<std::int64_t> parseInteger(std::string_view text);

/// Shortest text that reads back as the same number.
std::string formatNumber(double value);

} // namespace knittsim::formats
