#include "core/base/text_check.h"

#include <algorithm>
#include <array>

namespace knittsim {

namespace {

/// Text holds hardly any control characters; noise has one in ten bytes.
constexpr std::size_t kTextBytesPerControl = 20;

struct Mark {
    std::string_view bytes;
    const char* encoding;
};

constexpr std::string_view kUtf8Mark = "\xEF\xBB\xBF";

/// The longer ones first: UTF-32 begins as UTF-16 does.
constexpr std::array kOtherMarks{
    Mark{std::string_view("\xFF\xFE\0\0", 4), "UTF-32"},
    Mark{std::string_view("\0\0\xFE\xFF", 4), "UTF-32"},
    Mark{"\xFF\xFE", "UTF-16"},
    Mark{"\xFE\xFF", "UTF-16"},
};

constexpr bool isControl(char c) {
    return (c >= 0 && c < ' ' && c != '\t' && c != '\n' && c != '\r' && c != '\f') || c == 0x7F;
}

Place placeOf(std::string_view bytes, std::size_t at, const std::string& file) {
    const std::string_view before = bytes.substr(0, at);
    const std::size_t lineStart = before.rfind('\n') + 1; // npos + 1 is 0
    return Place{.file = file,
                 .line = 1 + static_cast<int>(std::ranges::count(before, '\n')),
                 .column = 1 + static_cast<int>(at - lineStart)};
}

} // namespace

std::string_view withoutByteOrderMark(std::string_view text) {
    return text.starts_with(kUtf8Mark) ? text.substr(kUtf8Mark.size()) : text;
}

std::optional<Diagnostic> whyNotText(std::string_view bytes, const std::string& file) {
    const Place start{.file = file, .line = 1, .column = 1};
    if (withoutByteOrderMark(bytes).empty()) {
        return Diagnostic{"KS0012", Severity::Error, start, {}};
    }
    for (const Mark& mark : kOtherMarks) {
        if (bytes.starts_with(mark.bytes)) {
            return Diagnostic{"KS0013", Severity::Error, start, {mark.encoding}};
        }
    }
    if (const std::size_t nul = bytes.find('\0'); nul != std::string_view::npos) {
        return Diagnostic{"KS0122", Severity::Error, placeOf(bytes, nul, file), {}};
    }
    const auto controls = static_cast<std::size_t>(std::ranges::count_if(bytes, isControl));
    if (controls * kTextBytesPerControl > bytes.size()) {
        return Diagnostic{
            "KS0014",
            Severity::Error,
            placeOf(bytes, static_cast<std::size_t>(std::ranges::find_if(bytes, isControl) - bytes.begin()),
                    file),
            {std::to_string(controls), std::to_string(bytes.size())}};
    }
    return std::nullopt;
}

} // namespace knittsim
