#pragma once

#include "core/machine/checks/check.h"
#include "core/pattern/course_works.h"
#include "core/pattern/lift.h"
#include "core/pattern/move_plan.h"
#include "core/yarn/yarn_library.h"
#include "knitted.h"
#include "shrink_chart.h"

#include <array>
#include <functional>

/// Charts that are compiled and lifted back.
namespace knittsim::pattern {

inline std::vector<LoopMove> planned(const Course& course) {
    std::vector<LoopMove> moves;
    for (const MoveStep& step : planMoves(course.moves)) {
        moves.insert(moves.end(), step.moves.begin(), step.moves.end());
    }
    return moves;
}

/// What is different in the lifted chart, or nothing.
inline std::string difference(const Chart& chart, const Lifted& back) {
    const Chart& found = back.project.chart;
    if (back.kept > 0) {
        return "courses " + back.notes.back().arguments[2] + " are kept as in the program";
    }
    if (found.width != chart.width || found.height() != chart.height()) {
        return "it has " + std::to_string(found.width) + " x " + std::to_string(found.height()) + " cells";
    }
    for (int c = 0; c < chart.height(); ++c) {
        for (int w = 0; w < chart.width; ++w) {
            if (found.at(w, c).stitch != chart.at(w, c).stitch ||
                (isWorked(chart.at(w, c).stitch) && found.at(w, c).yarn != chart.at(w, c).yarn)) {
                return "wale " + std::to_string(w) + " of course " + std::to_string(c);
            }
        }
        if (planned(found.course(c)) != planned(chart.course(c)) ||
            found.course(c).rack != chart.course(c).rack) {
            return "moves or racking of course " + std::to_string(c);
        }
    }
    return {};
}

inline std::string liftsBack(const Chart& chart) {
    const auto program = compile(chart);
    if (!program) {
        return {}; // of a chart that is being shrunk
    }
    const auto yarns = machine::carrierYarns(program.value(), yarn::YarnLibrary({}), yarn::defaultYarn());
    const auto back = lift(program.value(), machine::genericProfile(), yarns);
    return back ? difference(chart, back.value()) : "not lifted: " + back.diagnostics()[0].id;
}

/// The first error of the checks, or nothing.
inline std::string firstError(const Chart& chart) {
    const auto program = compile(chart);
    if (!program) {
        return {};
    }
    const machine::Timeline timeline(program.value(), machine::genericProfile());
    for (const Diagnostic& finding : machine::check(timeline)) {
        if (finding.severity == Severity::Error) {
            return finding.id;
        }
    }
    return {};
}

/// Rows from the top, an upper-case letter for yarns after the first; moves below each row.
inline std::string drawn(const Chart& chart) {
    std::string text;
    for (int c = chart.height() - 1; c >= 0; --c) {
        for (int w = 0; w < chart.width; ++w) {
            text += "kpbtmr.fguqnd"[static_cast<std::size_t>(chart.at(w, c).stitch)];
            text += static_cast<char>('0' + chart.at(w, c).yarn);
        }
        static const std::array kMethods{"", " intarsia", " birdseye", " ladder"};
        text += chart.course(c).rack != 0 ? " rack " + std::to_string(chart.course(c).rack) : "";
        text += kMethods[static_cast<std::size_t>(chart.course(c).colours)];
        for (const LoopMove& move : chart.course(c).moves) {
            text += ' ' + std::to_string(move.from) + '>' + std::to_string(move.to);
        }
        text += '\n';
    }
    return text;
}

inline void expectNone(const Chart& chart, const std::function<std::string(const Chart&)>& problem,
                       int seed) {
    ASSERT_TRUE(compile(chart)) << drawn(chart);
    if (const std::string found = problem(chart); !found.empty()) {
        const Chart least = shrinkChart(chart, [&](const Chart& c) { return !problem(c).empty(); });
        ADD_FAILURE() << "seed " << seed << ": " << problem(least) << "\n" << drawn(least);
    }
}

} // namespace knittsim::pattern
