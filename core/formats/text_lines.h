#pragma once

#include "core/formats/problems.h"

#include <cstddef>
#include <string>
#include <string_view>

namespace knittsim::formats {

/// Longer lines are refused (KS0116) and skipped. Bounds time and memory.
constexpr std::size_t kMaxLineBytes = 64 * 1024;

/// The lines of a text file, without their ends. Lines that are no text are said once a kind and skipped
/// (KS0116, KS0122); in lines that are not UTF-8 each broken byte becomes '?' (KS0113); CR LF and
/// a byte order mark are accepted (KS0112, KS0126).
class TextLines {
public:
    /// Both must outlive the lines.
    TextLines(std::string_view text, Problems& problems);

    /// Goes to the next good line. False at the end of the text and when the problems are full.
    bool next();

    /// The present line; valid until the next call of next().
    std::string_view line() const { return m_line; }

    /// 1-based number of the present line, 0 before the first.
    int number() const { return m_number; }

private:
    bool check(std::string_view line);

    std::string_view m_text;
    Problems& m_problems;
    std::string_view m_line;
    std::string m_repaired; ///< copy of a line that is not UTF-8
    int m_number = 0;
    bool m_saidLineEnds = false;
    bool m_saidNotUtf8 = false;
    bool m_saidNul = false;
};

} // namespace knittsim::formats
