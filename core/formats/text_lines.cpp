#include "core/formats/text_lines.h"

#include "core/base/text_check.h"
#include "core/formats/text.h"

#include <utility>

namespace knittsim::formats {

TextLines::TextLines(std::string_view text, Problems& problems)
    : m_text(withoutByteOrderMark(text)), m_problems(problems) {
    if (m_text.size() < text.size()) {
        m_problems.warn("KS0126", {1, 1});
    }
}

bool TextLines::next() {
    while (!m_text.empty() && !m_problems.full()) {
        const std::size_t end = m_text.find('\n');
        const std::string_view line = m_text.substr(0, end);
        m_text.remove_prefix(end == std::string_view::npos ? m_text.size() : end + 1);
        ++m_number;
        if (check(line)) {
            return true;
        }
    }
    return false;
}

bool TextLines::check(std::string_view line) {
    if (!line.empty() && line.back() == '\r') {
        while (!line.empty() && line.back() == '\r') {
            line.remove_suffix(1);
        }
        if (!std::exchange(m_saidLineEnds, true)) {
            m_problems.warn("KS0112", {m_number, static_cast<int>(line.size() % kMaxLineBytes) + 1});
        }
    }
    if (line.size() > kMaxLineBytes) {
        m_problems.error("KS0116", {m_number, 1},
                         {std::to_string(line.size()), std::to_string(kMaxLineBytes)});
        return false;
    }
    if (const std::size_t nul = line.find('\0'); nul != std::string_view::npos) {
        if (!std::exchange(m_saidNul, true)) {
            m_problems.error("KS0122", {m_number, static_cast<int>(nul) + 1});
        }
        return false;
    }
    m_line = line;
    if (!isUtf8(line)) {
        m_repaired = replaceBadUtf8(line);
        if (!std::exchange(m_saidNotUtf8, true)) {
            std::size_t bad = 0;
            while (bad < line.size() && line[bad] == m_repaired[bad]) {
                ++bad;
            }
            m_problems.warn("KS0113", {m_number, static_cast<int>(bad) + 1});
        }
        m_line = m_repaired;
    }
    return true;
}

} // namespace knittsim::formats
