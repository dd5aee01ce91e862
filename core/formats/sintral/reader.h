#pragma once

#include "core/base/result.h"
#include "core/machine/program.h"

#include <string>
#include <string_view>

namespace knittsim::formats::sintral {

/// The text of a file and its path, both empty where there is none.
struct Source {
    std::string_view text;
    std::string file;
};

/// Reads a Stoll Sintral program of the classic written form together with its jacquard text, runs its loops,
/// jumps and counters, and gives the strokes as operations. Any bytes are safe; time is bounded by
/// kMaxOperations, kMaxExecutedCommands and kMaxNeedlesPassed, memory by kMaxOperations and
/// kMaxWrittenCommands.
///
/// Not verified against files of a production machine. Inferred: the first `<1+>` of a jacquard goes to its
/// start row; V0 interleaves the needles (racking n + 0.25), V# the other way (n + 0.5), transfers are made
/// at racking n; systems work in written order whichever way the stroke goes; a carrier comes in at its first
/// stitch and goes out at the end.
///
/// Simulated: line numbers, comments, START, END, << >> <>, S:, Y:, YG:, S1..S6 T1 SX S0 S0Y, U^S UVS UXS, V0
/// VR VL V# VU, NPn=, REP, counters, IF, IFN, GOTO, GOSUB, JAn, PA:, FA=, PM:, SEN=. Kept as x-sintral: WM,
/// WMI, W+, MSEC. Kept with a warning: KS0151. Everything else is an error with its line and text, KS0150.
///
/// Errors and warnings: KS0108, KS0112, KS0113, KS0115, KS0116, KS0119, KS0121, KS0122, KS0125, KS0126,
/// KS0150 to KS0159.
Result<machine::Program> parse(const Source& program, const Source& jacquard);

/// Commands that a program may hold (more: KS0125).
constexpr std::size_t kMaxWrittenCommands = 200'000;

/// Commands that a program may run through, and needles that its strokes may pass.
constexpr long long kMaxExecutedCommands = 5'000'000;
constexpr long long kMaxNeedlesPassed = 100'000'000;

} // namespace knittsim::formats::sintral
