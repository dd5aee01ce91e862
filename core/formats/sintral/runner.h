#pragma once

#include "core/formats/sintral/command.h"
#include "core/formats/sintral/strokes.h"

#include <set>
#include <string>
#include <vector>

namespace knittsim::formats::sintral {

/// Runs the lines of a program: repeats, jumps, counters and conditions. Reports KS0151, KS0155, KS0156,
/// KS0159 and stops at the first error.
class Runner {
public:
    /// All must outlive the runner.
    Runner(const std::vector<Line>& lines, StrokeWriter& strokes, ProgramSink& sink, Problems& problems);

    void run();

private:
    struct Loop {
        std::size_t line; ///< first of the repeated ones
        long long left;   ///< times still to go
    };
    struct Call {
        std::size_t back;
        std::size_t last; ///< line of the called ones
    };

    bool runLine(const Line& line);
    bool runCommand(const Command& command, const Line& line);
    bool runSetting(const Command& command, const Line& line);
    bool unsimulated(const Command& command, const Line& line);
    bool repeat(const Command& command, const Line& line);
    bool repeatEnd(const Command& command, const Line& line);
    bool jump(const Command& command, const Line& line);
    bool call(const Command& command, const Line& line);
    bool holds(const Command& command) const;
    long long valueOf(const Expression& expression) const;
    std::size_t findLine(int number) const;
    bool fail(const char* id, Spot spot, std::vector<std::string> arguments);

    const std::vector<Line>& m_lines;
    StrokeWriter& m_strokes;
    ProgramSink& m_sink;
    Problems& m_problems;
    std::map<int, std::size_t> m_byNumber;
    std::map<int, long long> m_counters;
    std::vector<Loop> m_loops;
    std::vector<Call> m_calls;
    std::set<std::string> m_said;
    std::size_t m_next = 0;
    long long m_executed = 0; ///< commands, long ones more than once
    bool m_ended = false;
    bool m_skipping = false;
    Stroke m_stroke;
};

} // namespace knittsim::formats::sintral
