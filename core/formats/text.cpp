#include "core/formats/text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>

namespace knittsim::formats {

namespace {

struct CodePoint {
    std::uint32_t value = 0;
    std::size_t bytes = 0; ///< 0: the first byte is not the start of valid UTF-8
};

CodePoint decode(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(text[i]); };
    const std::uint8_t lead = byte(0);
    if (lead < 0x80) {
        return {lead, 1};
    }
    const std::size_t length = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
    if (lead < 0xC2 || lead > 0xF4 || text.size() < length) {
        return {};
    }
    std::uint32_t value = lead & (0x7FU >> length);
    for (std::size_t i = 1; i < length; ++i) {
        if ((byte(i) & 0xC0) != 0x80) {
            return {};
        }
        value = value << 6 | (byte(i) & 0x3FU);
    }
    constexpr std::array<std::uint32_t, 5> kLeast{0, 0, 0x80, 0x800, 0x10000};
    const bool surrogate = value >= 0xD800 && value <= 0xDFFF;
    if (value < kLeast[length] || value > 0x10FFFF || surrogate) {
        return {};
    }
    return {value, length};
}

bool isShowable(std::uint32_t c) {
    const bool control = c < 0x20 || (c >= 0x7F && c <= 0x9F);
    const bool direction =
        (c >= 0x200B && c <= 0x200F) || (c >= 0x2028 && c <= 0x202E) || (c >= 0x2066 && c <= 0x2069);
    return !control && !direction && c != 0xFEFF;
}

bool isAscii(std::string_view text) {
    std::uint8_t all = 0;
    for (const char c : text) {
        all = static_cast<std::uint8_t>(all | static_cast<std::uint8_t>(c));
    }
    return all < 0x80;
}

/// The digits without a leading plus, which from_chars does not take. Empty when there is no number.
std::string_view withoutPlus(std::string_view text) {
    if (text.size() > 1 && text[0] == '+' && text[1] != '-') {
        text.remove_prefix(1);
    }
    const std::size_t digit = !text.empty() && text[0] == '-' ? 1 : 0;
    const bool startsNumber =
        text.size() > digit && (text[digit] == '.' || (text[digit] >= '0' && text[digit] <= '9'));
    return startsNumber ? text : std::string_view();
}

} // namespace

std::string shown(std::string_view text) {
    std::string result;
    while (!text.empty()) {
        const CodePoint c = decode(text);
        const std::size_t bytes = std::max<std::size_t>(c.bytes, 1);
        if (result.size() + bytes > kShownBytes) {
            return result + "...";
        }
        if (c.bytes > 0 && isShowable(c.value)) {
            result += text.substr(0, bytes);
        } else {
            result += '?';
        }
        text.remove_prefix(bytes);
    }
    return result;
}

std::string quoted(std::string_view text) {
    if (text.empty()) {
        return "nothing";
    }
    std::string result(1, '\'');
    result += shown(text);
    result += '\'';
    return result;
}

bool isUtf8(std::string_view text) {
    if (isAscii(text)) {
        return true;
    }
    while (!text.empty()) {
        const std::size_t bytes = decode(text).bytes;
        if (bytes == 0) {
            return false;
        }
        text.remove_prefix(bytes);
    }
    return true;
}

std::string replaceBadUtf8(std::string_view text) {
    std::string result;
    result.reserve(text.size());
    while (!text.empty()) {
        const std::size_t bytes = decode(text).bytes;
        if (bytes == 0) {
            result += '?';
        } else {
            result += text.substr(0, bytes);
        }
        text.remove_prefix(std::max<std::size_t>(bytes, 1));
    }
    return result;
}

std::optional<std::size_t> findTypographicMinus(std::string_view text) {
    // Hyphens, figure, en and em dash, minus, small and full-width hyphen-minus.
    constexpr std::array<std::uint32_t, 10> kDashes{0x00AD, 0x2010, 0x2011, 0x2012, 0x2013,
                                                    0x2014, 0x2015, 0x2212, 0xFE63, 0xFF0D};
    for (std::size_t at = 0; at < text.size();) {
        const CodePoint c = decode(text.substr(at));
        if (c.bytes > 1 && std::find(kDashes.begin(), kDashes.end(), c.value) != kDashes.end()) {
            return at;
        }
        at += std::max<std::size_t>(c.bytes, 1);
    }
    return std::nullopt;
}

std::string_view trim(std::string_view text) {
    while (!text.empty() && isBlank(text.front())) {
        text.remove_prefix(1);
    }
    while (!text.empty() && isBlank(text.back())) {
        text.remove_suffix(1);
    }
    return text;
}

Token Tokens::next() {
    while (m_at < m_line.size() && isBlank(m_line[m_at])) {
        ++m_at;
    }
    const std::size_t begin = m_at;
    while (m_at < m_line.size() && !isBlank(m_line[m_at])) {
        ++m_at;
    }
    return {m_line.substr(begin, m_at - begin), static_cast<int>(begin) + 1};
}

std::optional<double> parseNumber(std::string_view text) {
    text = withoutPlus(text);
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (text.empty() || error == std::errc::invalid_argument || end != text.data() + text.size()) {
        return std::nullopt;
    }
    if (error == std::errc::result_out_of_range) {
        return std::numeric_limits<double>::infinity();
    }
    return value + 0.0; // turns -0 into 0
}

std::optional<std::int64_t> parseInteger(std::string_view text) {
    text = withoutPlus(text);
    std::int64_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (text.empty() || error == std::errc::invalid_argument || end != text.data() + text.size()) {
        return std::nullopt;
    }
    if (error == std::errc::result_out_of_range) {
        return std::numeric_limits<std::int64_t>::max();
    }
    return value;
}

std::string formatNumber(double value) {
    std::array<char, 32> buffer{};
    const auto [end, error] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
    return {buffer.data(), end};
}

} // namespace knittsim::formats
