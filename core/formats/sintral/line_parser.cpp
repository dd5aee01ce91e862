#include "core/formats/sintral/line_parser.h"

#include "core/formats/sintral/words.h"

#include <algorithm>
#include <array>

namespace knittsim::formats::sintral {

using Kind = Command::Kind;

namespace {

constexpr std::size_t kMaxCycle = 100'000;
constexpr int kMaxRack = 100;
constexpr int kMaxCarrier = 16;

/// Commands that are known to exist but not simulated, by their beginning.
constexpr auto kUnsimulated = std::to_array<std::string_view>(
    {"RBEG", "REND", "SBEG", "SEND", "MCWS", "F:", "YGX", "YX", "YLR", "YD", "Y-", "WMF", "MSEC", "ML"});

bool number(std::string_view text, int& value) {
    value = smallNumber(text);
    return value >= 0;
}

/// "a-b"
bool range(std::string_view text, int& first, int& last) {
    const std::string_view begin = takePart(text, '-');
    return number(begin, first) && number(text, last);
}

/// "12", "#3", "#3+1"
bool expression(std::string_view text, Expression& result) {
    int sign = 1;
    while (true) {
        Expression::Term term;
        term.sign = sign;
        term.counter = takePrefix(text, "#");
        const std::size_t end = text.find_first_of("+-");
        if (!number(text.substr(0, end), term.value)) {
            return false;
        }
        result.terms.push_back(term);
        if (end == std::string_view::npos) {
            return true;
        }
        sign = text[end] == '+' ? 1 : -1;
        text.remove_prefix(end + 1);
    }
}

/// "#50=1", "#50<>#3"
bool condition(std::string_view text, Command& command) {
    constexpr std::array<std::pair<std::string_view, Comparison>, 6> kSigns{
        {{"<>", Comparison::Unequal},
         {"<=", Comparison::LessOrEqual},
         {">=", Comparison::GreaterOrEqual},
         {"=", Comparison::Equal},
         {"<", Comparison::Less},
         {">", Comparison::Greater}}};
    const std::size_t end = text.find_first_of("<>=");
    if (!takePrefix(text, "#") || end == std::string_view::npos ||
        !number(text.substr(0, end - 1), command.value)) {
        return false;
    }
    text.remove_prefix(end - 1);
    for (const auto& [sign, comparison] : kSigns) {
        if (takePrefix(text, sign)) {
            command.comparison = comparison;
            return expression(text, command.expression);
        }
    }
    return false;
}

/// "2/3/0" or "10(4/4/3) 10(5/1/1)": repeated lists follow each other.
bool cycle(std::string_view text, std::vector<int>& carriers) {
    while (!(text = trim(text)).empty()) {
        const std::size_t open = text.find('(');
        std::string_view list = text;
        int times = 1;
        if (open != std::string_view::npos) {
            const std::size_t close = text.find(')');
            if (!number(trim(text.substr(0, open)), times) || close == std::string_view::npos ||
                close < open) {
                return false;
            }
            list = text.substr(open + 1, close - open - 1);
            text.remove_prefix(close + 1);
        } else {
            text = {};
        }
        std::vector<int> once;
        while (!list.empty()) {
            int carrier = 0;
            if (!number(trim(takePart(list, '/')), carrier) || carrier > kMaxCarrier) {
                return false;
            }
            once.push_back(carrier);
        }
        if (once.empty() || carriers.size() + once.size() * static_cast<std::size_t>(times) > kMaxCycle) {
            return false;
        }
        for (int i = 0; i < times; ++i) {
            carriers.insert(carriers.end(), once.begin(), once.end());
        }
    }
    return !carriers.empty();
}

/// "6/2335": digits of the carriers on the left and on the right.
bool homes(std::string_view text, Command& command) {
    const std::size_t slash = text.find('/');
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (i == slash) {
            command.value = static_cast<int>(command.numbers.size());
        } else if (isDigit(text[i])) {
            command.numbers.push_back(text[i] - '0');
        } else if (!isBlank(text[i])) {
            return false;
        }
    }
    return slash != std::string_view::npos;
}

bool rack(std::string_view text, Command& command) {
    command.kind = Kind::Rack;
    command.fraction = 0.25;
    if (text == "0") {
        return true;
    }
    if (text == "#" || text == "U") {
        command.fraction = text == "#" ? 0.5 : 0;
        return true;
    }
    const bool left = !text.empty() && text[0] == 'L';
    if (!takePrefix(text, "R") && !takePrefix(text, "L")) {
        return false;
    }
    if (!number(text, command.value) || command.value > kMaxRack) {
        return false;
    }
    command.value = left ? -command.value : command.value;
    return true;
}

/// Goes through the words of one line.
class LineParser {
public:
    LineParser(std::string_view text, int column, Line& line, Problems& problems)
        : m_text(text), m_column(column), m_line(line), m_problems(problems) {}

    bool run();

private:
    std::string_view nextWord();
    bool parse(std::string_view word);
    bool parseColon(std::string_view word);
    bool parseEquals(std::string_view word);
    bool parseFlow(std::string_view word);
    bool parseYarns(std::string_view word);
    bool add(Kind kind);
    bool unsimulated(std::string_view word, Kind kind = Kind::Unsimulated);
    bool wrong(std::string_view word, const char* expected);

    std::string_view m_text;
    int m_column;
    Line& m_line;
    Problems& m_problems;
    std::size_t m_at = 0;
    std::size_t m_begin = 0; ///< of the present word
    Command m_command;
};

bool LineParser::run() {
    for (std::string_view word = nextWord(); !word.empty(); word = nextWord()) {
        // A comment goes to the end of the line.
        if (word == "C" || word == "CC") {
            return true;
        }
        m_command = {};
        m_command.column = m_column + static_cast<int>(m_begin);
        if (!parse(word)) {
            return false;
        }
    }
    return true;
}

/// Words end at blanks; those with a colon at the ';', in which blanks do not count.
std::string_view LineParser::nextWord() {
    while (m_at < m_text.size() && (isBlank(m_text[m_at]) || m_text[m_at] == ';')) {
        ++m_at;
    }
    m_begin = m_at;
    bool colon = false;
    while (m_at < m_text.size() && m_text[m_at] != ';' && (colon || !isBlank(m_text[m_at]))) {
        colon = colon || m_text[m_at] == ':';
        ++m_at;
    }
    return trim(m_text.substr(m_begin, m_at - m_begin));
}

bool LineParser::add(Kind kind) {
    m_command.kind = kind;
    m_line.commands.push_back(std::move(m_command));
    return true;
}

bool LineParser::unsimulated(std::string_view word, Kind kind) {
    m_command.text = word;
    return add(kind);
}

bool LineParser::wrong(std::string_view word, const char* expected) {
    m_problems.error("KS0108", {m_line.place, m_command.column}, {quoted(word), expected});
    return false;
}

bool LineParser::parse(std::string_view word) {
    if (word == "START" || word == "END") {
        return add(word == "START" ? Kind::Start : Kind::End);
    }
    if (word == "<<" || word == ">>") {
        m_command.direction = word == "<<" ? machine::Direction::Left : machine::Direction::Right;
        return add(Kind::Direction);
    }
    if (word == "<>") {
        return add(Kind::Direction);
    }
    if (word == "S0" || word == "S0Y") {
        return add(Kind::EmptyStroke);
    }
    const bool system = word.size() == 2 && word[0] == 'S' && word[1] >= '1' && word[1] <= '6';
    if (system || word == "T1" || word == "SX") {
        return add(Kind::System);
    }
    if (word.substr(0, 5) == "FBEG:") {
        return unsimulated(word, Kind::SkipBegin);
    }
    if (word == "FEND") {
        // A label may follow.
        m_at = m_text.size();
        return add(Kind::SkipEnd);
    }
    if (parseFlow(word)) {
        return true;
    }
    if (word[0] == 'V' && word.substr(0, 2) != "VV" && rack(word.substr(1), m_command)) {
        return add(Kind::Rack);
    }
    const bool keep = word.substr(0, 3) == "WM=" || word.substr(0, 4) == "WMI=" ||
                      word.substr(0, 2) == "W+" || word.substr(0, 5) == "MSEC=";
    if (keep) {
        m_command.text = word;
        return add(Kind::Keep);
    }
    for (const std::string_view beginning : kUnsimulated) {
        if (word.substr(0, beginning.size()) == beginning) {
            return unsimulated(word);
        }
    }
    if (word.find(':') != std::string_view::npos) {
        return parseColon(word);
    }
    return parseEquals(word);
}

/// REP, REPEND, IF, IFN, GOTO, GOSUB; the word behind them belongs to them.
bool LineParser::parseFlow(std::string_view word) {
    if (word == "REPEND") {
        return add(Kind::RepeatEnd);
    }
    std::string_view times = word;
    if (takePrefix(times, "REP*") && expression(times, m_command.expression)) {
        return add(Kind::Repeat);
    }
    const bool condition_ = word == "IF" || word == "IFN";
    if (!condition_ && word != "GOTO" && word != "GOSUB") {
        return false;
    }
    const std::size_t at = m_at;
    const std::string_view argument = nextWord();
    m_command.negated = word == "IFN";
    if (condition_ && condition(argument, m_command)) {
        return add(Kind::If);
    }
    if (word == "GOTO" && number(argument, m_command.value)) {
        return add(Kind::Goto);
    }
    if (word == "GOSUB" && range(argument, m_command.value, m_command.value2)) {
        return add(Kind::Gosub);
    }
    m_at = at;
    return false;
}

bool LineParser::parseColon(std::string_view word) {
    std::string_view value = word;
    const std::string_view name = takePart(value, ':');
    if (name == "S") {
        std::string_view bad;
        auto systems = parseSystems(value, bad);
        if (!systems) {
            return wrong(bad, "needles of the front and the rear bed for each system, such as R-R/R-0");
        }
        m_command.systems = std::move(*systems);
        m_command.text = word;
        return add(Kind::Systems);
    }
    if (name == "Y" || name == "YG") {
        return parseYarns(word);
    }
    if (name == "PA" && takePrefix(value, "JA") && number(value, m_command.value)) {
        return add(Kind::UseJacquard);
    }
    if (name == "PM") {
        const std::string_view needle = takePart(value, ':');
        if (number(needle, m_command.value) && trim(value) == "FA") {
            return add(Kind::PlaceField);
        }
        return wrong(word, "PM:needle:FA;");
    }
    m_problems.error("KS0150", {m_line.place, m_command.column}, {quoted(word)});
    return false;
}

bool LineParser::parseYarns(std::string_view word) {
    std::string_view value = word;
    const std::string_view name = takePart(value, ':');
    // Yarn types, carriers that follow the needles or go home.
    if (value.find_first_of("=SHK") != std::string_view::npos) {
        return unsimulated(word);
    }
    if (name == "Y" && cycle(value, m_command.numbers)) {
        return add(Kind::Carriers);
    }
    if (name == "YG" && homes(value, m_command)) {
        return add(Kind::Homes);
    }
    return wrong(word, name == "Y" ? "a carrier from 0 to 16 for each system, such as 2/3/0"
                                   : "carriers on the left and on the right, such as 6/23");
}

bool LineParser::parseEquals(std::string_view word) {
    std::string_view value = word;
    std::string_view name = takePart(value, '=');
    if (name == "SEN" || name == "FA") {
        if (!range(value, m_command.value, m_command.value2) || m_command.value > m_command.value2 ||
            m_command.value < 1 || m_command.value2 > static_cast<int>(kMaxCycle)) {
            return wrong(word, "two numbers, the first not above the second");
        }
        return add(name == "SEN" ? Kind::Range : Kind::Field);
    }
    if (takePrefix(name, "JA") && number(name, m_command.value) && number(value, m_command.value2)) {
        return add(Kind::JacquardStart);
    }
    if (takePrefix(name, "NP") && number(name, m_command.value)) {
        const auto stitch = parseNumber(value);
        if (!stitch || *stitch < 0 || *stitch > 1000) {
            return wrong(word, "a stitch cam value from 0 to 1000");
        }
        m_command.fraction = *stitch;
        return add(Kind::StitchValue);
    }
    if (takePrefix(name, "#") && number(name, m_command.value) && expression(value, m_command.expression)) {
        return add(Kind::Set);
    }
    m_problems.error("KS0150", {m_line.place, m_command.column}, {quoted(word)});
    return false;
}

} // namespace

bool parseCommands(std::string_view text, int column, Line& line, Problems& problems) {
    return LineParser(text, column, line, problems).run();
}

} // namespace knittsim::formats::sintral
