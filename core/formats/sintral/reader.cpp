#include "core/formats/sintral/reader.h"

#include "core/formats/sintral/line_parser.h"
#include "core/formats/sintral/runner.h"
#include "core/formats/sintral/words.h"
#include "core/formats/text_lines.h"

#include <algorithm>
#include <array>

namespace knittsim::formats::sintral {

using machine::CarrierIndex;
using machine::CarrierSet;

namespace {

constexpr int kFirstJacquardLine = 1000; ///< lower numbers are the program

/// Turns carrier numbers into places of the header, which lists those that are used.
void nameCarriers(machine::Program& program, const StrokeWriter& strokes) {
    std::array<CarrierIndex, 256> place{};
    for (const int number : strokes.usedCarriers()) {
        const std::size_t index = program.header.carriers.size();
        place[static_cast<std::size_t>(number)] = static_cast<CarrierIndex>(index);
        program.header.carriers.push_back(
            {std::to_string(number), static_cast<int>(index), strokes.parksRight(number), {}});
    }
    for (machine::Operation& op : program.operations) {
        if (!op.carriers.empty()) {
            op.carriers = CarrierSet{place[op.carriers[0]]};
        }
    }
}

class Reader {
public:
    Reader(const Source& program, const Source& jacquard)
        : m_source(program), m_jacquardSource(jacquard), m_problems(program.file, kMaxErrors),
          m_jacquardProblems(jacquard.file, kMaxErrors) {}

    Result<machine::Program> run() {
        readJacquard();
        readLines();
        machine::Program program;
        program.file = m_source.file;
        program.header.machine = "Stoll";
        if (good()) {
            ProgramSink sink(program, m_problems);
            StrokeWriter strokes(m_jacquard, sink, m_problems);
            Runner(m_lines, strokes, sink, m_problems).run();
            nameCarriers(program, strokes);
            if (good() && program.operations.empty()) {
                m_problems.error("KS0121", {std::max(m_lineCount, 1), 1});
            }
        }
        const bool success = good();
        Diagnostics found = m_problems.take();
        for (Diagnostic& diagnostic : m_jacquardProblems.take()) {
            found.push_back(std::move(diagnostic));
        }
        if (!success) {
            return Result<machine::Program>::failure(std::move(found));
        }
        return {std::move(program), std::move(found)};
    }

private:
    bool good() const { return m_problems.errorCount() == 0 && m_jacquardProblems.errorCount() == 0; }

    void readJacquard() {
        TextLines lines(m_jacquardSource.text, m_jacquardProblems);
        while (lines.next()) {
            const std::string_view text = trim(lines.line());
            if (!text.empty() && !m_jacquard.addLine(lines.line(), {lines.number(), 1}, m_jacquardProblems)) {
                return;
            }
        }
        m_jacquard.finish({std::max(lines.number(), 1), 1}, m_jacquardProblems);
    }

    void readLines() {
        TextLines lines(m_source.text, m_problems);
        while (lines.next()) {
            m_lineCount = lines.number();
            readLine(lines.line(), lines.number());
            if (m_commandCount > kMaxWrittenCommands) {
                m_problems.error("KS0125", {m_lineCount, 1}, {std::to_string(kMaxWrittenCommands)});
                return;
            }
        }
        m_jacquard.finish({std::max(lines.number(), 1), 1}, m_problems);
    }

    /// A number at the beginning is that of the line; from 1000 on it is a row of the jacquard.
    void readLine(std::string_view text, int place) {
        Tokens tokens(text);
        const Token first = tokens.peek();
        Line line;
        line.place = place;
        line.number = smallNumber(first.text);
        std::size_t begin = 0;
        if (line.number >= kFirstJacquardLine) {
            m_badRows = m_badRows || !m_jacquard.addLine(text, {place, 1}, m_problems);
            return;
        }
        if (line.number >= 0) {
            begin = static_cast<std::size_t>(first.column) - 1 + first.text.size();
        }
        if (parseCommands(text.substr(begin), static_cast<int>(begin) + 1, line, m_problems) &&
            (!line.commands.empty() || line.number >= 0)) {
            m_commandCount += line.commands.size();
            m_lines.push_back(std::move(line));
        }
    }

    const Source& m_source;
    const Source& m_jacquardSource;
    Problems m_problems;
    Problems m_jacquardProblems;
    Jacquard m_jacquard;
    std::vector<Line> m_lines;
    std::size_t m_commandCount = 0;
    int m_lineCount = 0;
    bool m_badRows = false; ///< one of the jacquard rows in the program is wrong
};

} // namespace

Result<machine::Program> parse(const Source& program, const Source& jacquard) {
    return Reader(program, jacquard).run();
}

} // namespace knittsim::formats::sintral
