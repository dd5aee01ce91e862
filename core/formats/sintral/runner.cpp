#include "core/formats/sintral/runner.h"

#include "core/formats/sintral/reader.h"
#include "core/formats/text.h"

#include <algorithm>

namespace knittsim::formats::sintral {

using Kind = Command::Kind;

namespace {

constexpr std::size_t kMaxDepth = 1000; ///< of repeats and of calls
constexpr long long kMaxCounter = 1'000'000'000;

/// The name of a command without its values, so that each kind is said once.
std::string kindOf(std::string_view text) {
    const std::size_t end = text.find_first_of("0123456789=:*<");
    return std::string(text.substr(0, std::max<std::size_t>(end, 1)));
}

} // namespace

Runner::Runner(const std::vector<Line>& lines, StrokeWriter& strokes, ProgramSink& sink, Problems& problems)
    : m_lines(lines), m_strokes(strokes), m_sink(sink), m_problems(problems) {
    for (std::size_t i = 0; i < lines.size(); ++i) {
        if (lines[i].number >= 0) {
            m_byNumber.emplace(lines[i].number, i);
        }
    }
}

void Runner::run() {
    while (m_next < m_lines.size() && !m_ended) {
        const std::size_t index = m_next++;
        const Line& line = m_lines[index];
        if (!runLine(line) || m_problems.errorCount() > 0) {
            return;
        }
        if (!m_calls.empty() && index == m_calls.back().last && m_next == index + 1) {
            m_next = m_calls.back().back;
            m_calls.pop_back();
        }
    }
    m_strokes.finish();
}

bool Runner::runLine(const Line& line) {
    m_sink.setLine(line.place);
    m_stroke = {};
    ++m_executed;
    for (const Command& command : line.commands) {
        m_executed += 1 + static_cast<long long>(command.numbers.size() + command.systems.entries.size());
        if (m_executed > kMaxExecutedCommands) {
            return fail("KS0156", {line.place, command.column},
                        {std::to_string(kMaxExecutedCommands) + " commands"});
        }
        if (m_skipping && command.kind != Kind::SkipEnd) {
            continue;
        }
        if (command.kind == Kind::If) {
            if (!holds(command)) {
                break;
            }
            continue;
        }
        if (!runCommand(command, line)) {
            return false;
        }
    }
    return !m_stroke.wanted || m_strokes.carryOut(m_stroke, {line.place, 1});
}

bool Runner::runCommand(const Command& command, const Line& line) {
    switch (command.kind) {
    case Kind::End:
        m_ended = true;
        return true;
    case Kind::Direction:
        m_stroke.wanted = true;
        m_stroke.direction = command.direction;
        return true;
    case Kind::System:
        m_stroke.wanted = m_stroke.named = true;
        ++m_stroke.systems;
        return true;
    case Kind::EmptyStroke:
        m_stroke.wanted = m_stroke.empty = true;
        return true;
    case Kind::Rack:
        m_stroke.rack = command.value;
        m_stroke.fraction = command.fraction;
        return true;
    case Kind::Keep:
        m_sink.extension("x-sintral " + command.text);
        return true;
    case Kind::Unsimulated:
    case Kind::SkipBegin:
        m_skipping = command.kind == Kind::SkipBegin;
        return unsimulated(command, line);
    case Kind::SkipEnd:
        m_skipping = false;
        return true;
    case Kind::Repeat:
        return repeat(command, line);
    case Kind::RepeatEnd:
        return repeatEnd(command, line);
    case Kind::Goto:
        return jump(command, line);
    case Kind::Gosub:
        return call(command, line);
    case Kind::Set:
        m_counters[command.value] = std::clamp(valueOf(command.expression), -kMaxCounter, kMaxCounter);
        return true;
    default:
        return runSetting(command, line);
    }
}

bool Runner::runSetting(const Command& command, const Line& line) {
    const Spot spot{line.place, command.column};
    switch (command.kind) {
    case Kind::Systems:
        m_strokes.setSystems(command.systems);
        return !command.systems.field || unsimulated(command, line);
    case Kind::Carriers:
        m_strokes.setCarriers(command.numbers);
        return true;
    case Kind::Homes:
        m_strokes.setHomes(command);
        return true;
    case Kind::JacquardStart:
        return m_strokes.startJacquard(command.value, command.value2, spot);
    case Kind::UseJacquard:
        return m_strokes.useJacquard(command.value, spot);
    case Kind::Field:
        m_strokes.setField(command.value, command.value2);
        return true;
    case Kind::PlaceField:
        m_strokes.placeField(command.value);
        return true;
    case Kind::Range:
        m_strokes.setRange(command.value, command.value2);
        return true;
    case Kind::StitchValue:
        m_strokes.setStitchValue(command.value, command.fraction);
        return true;
    default: // START
        return true;
    }
}

bool Runner::unsimulated(const Command& command, const Line& line) {
    m_sink.extension("x-sintral " + shown(command.text));
    if (m_said.insert(kindOf(command.text)).second) {
        m_problems.warn("KS0151", {line.place, command.column}, {quoted(command.text)});
    }
    return true;
}

bool Runner::repeat(const Command& command, const Line& line) {
    if (m_loops.size() == kMaxDepth) {
        return fail("KS0156", {line.place, command.column}, {std::to_string(kMaxDepth) + " nested repeats"});
    }
    m_loops.push_back({m_next, valueOf(command.expression) - 1});
    return true;
}

bool Runner::repeatEnd(const Command& command, const Line& line) {
    if (m_loops.empty()) {
        return fail("KS0159", {line.place, command.column}, {"REPEND", "REP"});
    }
    if (m_loops.back().left > 0) {
        --m_loops.back().left;
        m_next = m_loops.back().line;
    } else {
        m_loops.pop_back();
    }
    return true;
}

std::size_t Runner::findLine(int number) const {
    const auto found = m_byNumber.find(number);
    return found == m_byNumber.end() ? m_lines.size() : found->second;
}

bool Runner::jump(const Command& command, const Line& line) {
    const std::size_t target = findLine(command.value);
    if (target == m_lines.size()) {
        return fail("KS0155", {line.place, command.column}, {"line", std::to_string(command.value)});
    }
    m_next = target;
    return true;
}

bool Runner::call(const Command& command, const Line& line) {
    const std::size_t first = findLine(command.value);
    const std::size_t last = findLine(command.value2);
    if (first == m_lines.size() || last == m_lines.size() || last < first) {
        return fail("KS0155", {line.place, command.column},
                    {"lines", std::to_string(command.value) + "-" + std::to_string(command.value2)});
    }
    if (m_calls.size() == kMaxDepth) {
        return fail("KS0156", {line.place, command.column}, {std::to_string(kMaxDepth) + " nested calls"});
    }
    m_calls.push_back({m_next, last});
    m_next = first;
    return true;
}

bool Runner::holds(const Command& command) const {
    const auto found = m_counters.find(command.value);
    const long long a = found == m_counters.end() ? 0 : found->second;
    const long long b = valueOf(command.expression);
    const auto compare = [&] {
        switch (command.comparison) {
        case Comparison::Equal:
            return a == b;
        case Comparison::Unequal:
            return a != b;
        case Comparison::Less:
            return a < b;
        case Comparison::LessOrEqual:
            return a <= b;
        case Comparison::Greater:
            return a > b;
        case Comparison::GreaterOrEqual:
            break;
        }
        return a >= b;
    };
    return compare() != command.negated;
}

long long Runner::valueOf(const Expression& expression) const {
    long long value = 0;
    for (const Expression::Term& term : expression.terms) {
        long long number = term.value;
        if (term.counter) {
            const auto found = m_counters.find(term.value);
            number = found == m_counters.end() ? 0 : found->second;
        }
        value += term.sign * number;
    }
    return value;
}

bool Runner::fail(const char* id, Spot spot, std::vector<std::string> arguments) {
    m_problems.error(id, spot, std::move(arguments));
    return false;
}

} // namespace knittsim::formats::sintral
