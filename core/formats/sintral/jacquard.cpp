#include "core/formats/sintral/jacquard.h"

#include "core/formats/sintral/words.h"
#include "core/formats/text.h"

#include <algorithm>
#include <utility>

namespace knittsim::formats::sintral {

namespace {

constexpr char kContinues = '$';

/// Decodes the symbols of one line. Says in words what is wrong, or nothing.
class Decoder {
public:
    Decoder(std::string_view text, std::string& row) : m_text(text), m_row(row) {}

    const char* run() {
        while (m_at < m_text.size()) {
            const int count = takeCount();
            if (m_at == m_text.size()) {
                return "a number without a symbol";
            }
            const std::string_view group = takeGroup();
            if (group.empty() || !std::all_of(group.begin(), group.end(), isSymbol)) {
                return "a sign that is no symbol";
            }
            if (count < 0 ||
                m_row.size() + static_cast<std::size_t>(count) * group.size() > Jacquard::kMaxColumns) {
                return "more than 10000 symbols in a row";
            }
            for (int i = 0; i < count; ++i) {
                m_row += group;
            }
        }
        return nullptr;
    }

private:
    /// 1 where there is no number, -1 for one that is too large.
    int takeCount() {
        const std::size_t begin = m_at;
        while (m_at < m_text.size() && isDigit(m_text[m_at])) {
            ++m_at;
        }
        return begin == m_at ? 1 : smallNumber(m_text.substr(begin, m_at - begin));
    }

    std::string_view takeGroup() {
        if (m_text[m_at] != '(') {
            return m_text.substr(m_at++, 1);
        }
        const std::size_t end = m_text.find(')', m_at);
        if (end == std::string_view::npos) {
            return {};
        }
        const std::string_view group = m_text.substr(m_at + 1, end - m_at - 1);
        m_at = end + 1;
        return group;
    }

    std::string_view m_text;
    std::string& m_row;
    std::size_t m_at = 0;
};

} // namespace

bool Jacquard::addLine(std::string_view line, Spot spot, Problems& problems) {
    Tokens tokens(line);
    const Token number = tokens.next();
    const Token symbols = tokens.next();
    const auto fail = [&](const Token& token, const char* why) {
        problems.error("KS0153", {spot.line, token.column}, {why});
        return false;
    };
    const int value = smallNumber(number.text);
    if (value < 0) {
        return fail(number, "a line number is missing");
    }
    if (!tokens.peek().text.empty()) {
        return fail(tokens.peek(), "blanks between symbols");
    }
    std::string_view text = symbols.text;
    const bool goesOn = !text.empty() && text.front() == kContinues;
    if (goesOn != m_open) {
        return fail(symbols, m_open ? "the row before is not continued" : "there is no row to continue");
    }
    text.remove_prefix(goesOn ? 1 : 0);
    m_open = !text.empty() && text.back() == kContinues;
    text.remove_suffix(m_open ? 1 : 0);
    if (!goesOn) {
        m_byLine.emplace(value, rowCount());
        m_rows.emplace_back();
    }
    const std::size_t before = m_rows.back().size();
    if (const char* why = Decoder(text, m_rows.back()).run()) {
        return fail(symbols, why);
    }
    m_symbols += m_rows.back().size() - before;
    return m_symbols <= kMaxSymbols || fail(symbols, "too many symbols");
}

bool Jacquard::finish(Spot spot, Problems& problems) {
    if (!std::exchange(m_open, false)) {
        return true;
    }
    problems.error("KS0153", spot, {"the last row is not continued"});
    return false;
}

int Jacquard::findRow(int lineNumber) const {
    const auto found = m_byLine.find(lineNumber);
    return found == m_byLine.end() ? -1 : found->second;
}

} // namespace knittsim::formats::sintral
