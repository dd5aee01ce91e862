#pragma once

#include "core/base/result.h"
#include "core/machine/profile.h"
#include "core/machine/program.h"
#include "core/pattern/chart.h"

namespace knittsim::pattern {

enum class CastOn : std::uint8_t {
    Open,        ///< the first course is knitted on empty needles
    Alternating, ///< before it, tucks on every second needle one way and on the others back
};

enum class Ending : std::uint8_t {
    Held,    ///< the last loops stay on their needles, as on a stitch holder
    Dropped, ///< they fall off: the last course can ladder
};

/// Needle of wale 0, unless it is said otherwise.
constexpr int kFirstNeedle = 1;

struct CompileOptions {
    CastOn castOn = CastOn::Alternating;
    Ending ending = Ending::Held;
    int firstNeedle = kFirstNeedle;
    machine::MachineProfile machine = machine::genericProfile();
};

struct Compiled {
    machine::Program program;
    std::vector<machine::OperationIndex> courseEnds; ///< operations done after each course of the chart
};

/// Machine program that knits the chart.
///
/// - A carrier comes in for its first course, which it knits leftwards, and leaves after its last one.
/// - Each course: loops are moved (all to the rear bed, then racking by racking to the front), loops change
/// beds
///   where the stitch asks for it (racking 0), then every yarn passes once, away from the side where it
///   stands.
/// - Intarsia: zones are knitted in the direction of the carrier, each yarn tucking on the first wale of the
/// next zone.
///
/// Errors: KS0008 and KS0501 to KS0508, with course and needle.
Result<Compiled> compileCourses(const Chart& chart, const CompileOptions& options = {});

/// The program alone.
Result<machine::Program> compile(const Chart& chart, const CompileOptions& options = {});

} // namespace knittsim::pattern
