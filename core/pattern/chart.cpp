#include "core/pattern/chart.h"

#include "core/pattern/program_course.h"

#include <algorithm>

namespace knittsim::pattern {

Chart::Chart(int wales, int courseCount, Stitch stitch)
    : width(wales),
      cells(static_cast<std::size_t>(wales) * static_cast<std::size_t>(courseCount), Cell{stitch, 0}),
      courses(static_cast<std::size_t>(courseCount)) {}

bool Course::operator==(const Course& other) const {
    return moves == other.moves && colours == other.colours && rack == other.rack &&
           stitchNumber == other.stitchNumber &&
           (program == other.program || (program && other.program && *program == *other.program));
}

namespace {

Diagnostic problem(const char* id, int course, std::vector<std::string> arguments) {
    return {id, Severity::Error, Place{.course = course}, std::move(arguments)};
}

void checkCells(const Chart& chart, int course, Diagnostics& problems) {
    for (int wale = 0; wale < chart.width; ++wale) {
        const Cell cell = chart.at(wale, course);
        if (isWorked(cell.stitch) && cell.yarn >= chart.yarns.size()) {
            problems.push_back(problem(
                "KS0502", course,
                {std::to_string(wale), std::to_string(cell.yarn), std::to_string(chart.yarns.size())}));
            return;
        }
        if (needsTwoBeds(cell.stitch) && chart.beds == BedUse::Single &&
            !isAsInProgram(chart, wale, course)) {
            problems.push_back(problem("KS0504", course, {"a stitch that names both beds", "two beds"}));
            return;
        }
    }
}

void checkMoves(const Chart& chart, int course, Diagnostics& problems) {
    const std::vector<LoopMove>& moves = chart.course(course).moves;
    if (!addedMoves(chart.course(course)).empty() && chart.beds == BedUse::Double) {
        problems.push_back(problem("KS0504", course, {"a moved loop", "one bed"}));
    }
    std::vector<bool> moved(static_cast<std::size_t>(chart.width), false);
    for (const LoopMove& move : moves) {
        const auto inside = [&](int wale) { return wale >= 0 && wale < chart.width; };
        if (!inside(move.from) || !inside(move.to) || move.from == move.to ||
            moved[static_cast<std::size_t>(move.from)]) {
            problems.push_back(
                problem("KS0503", course, {std::to_string(move.from), std::to_string(move.to)}));
            return;
        }
        moved[static_cast<std::size_t>(move.from)] = true;
    }
}

} // namespace

Diagnostics check(const Chart& chart) {
    const auto cellCount = static_cast<std::size_t>(std::max(chart.width, 0)) * chart.courses.size();
    if (chart.width < 1 || chart.width > kMaxWales || chart.courses.empty() || chart.height() > kMaxCourses ||
        chart.cells.size() != cellCount) {
        return {problem("KS0501", -1,
                        {std::to_string(chart.width), std::to_string(chart.courses.size()),
                         std::to_string(chart.cells.size())})};
    }
    Diagnostics problems;
    for (int course = 0; course < chart.height(); ++course) {
        checkCells(chart, course, problems);
        checkMoves(chart, course, problems);
        if (chart.course(course).rack != 0 && chart.beds == BedUse::Single) {
            problems.push_back(problem("KS0504", course, {"racking", "two beds"}));
        }
        if (isBacked(chart.course(course).colours) && chart.beds == BedUse::Single) {
            problems.push_back(problem("KS0504", course, {"a back of the colours", "two beds"}));
        }
    }
    return problems;
}

std::vector<LoopMove> cross(int wale, int left, int right, Front front) {
    std::vector<LoopMove> moves;
    for (int i = 0; i < left; ++i) {
        moves.push_back({wale + i, wale + i + right});
    }
    for (int i = 0; i < right; ++i) {
        moves.push_back({wale + left + i, wale + i});
    }
    if (front == Front::Right) {
        std::rotate(moves.begin(), moves.begin() + left, moves.end());
    }
    return moves;
}

} // namespace knittsim::pattern
