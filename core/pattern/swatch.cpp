#include "core/pattern/swatch.h"

#include "core/pattern/compile.h"
#include "core/yarn/yarn_library.h"

namespace knittsim::pattern {

namespace {

/// Purl where isPurl(wale, course), else knit.
template<class IsPurl> Chart twoBedChart(int wales, int courses, IsPurl isPurl) {
    Chart chart(wales, courses);
    chart.yarns = {
        {.carrier = "1", .colour = yarn::defaultYarn().colour, .libraryId = yarn::defaultYarn().id}};
    for (int course = 0; course < courses; ++course) {
        for (int wale = 0; wale < wales; ++wale) {
            chart.at(wale, course).stitch = isPurl(wale, course) ? Stitch::Purl : Stitch::Knit;
        }
    }
    return chart;
}

machine::Program withoutCastOn(const Chart& chart) {
    Result<machine::Program> program = compile(chart, {.castOn = CastOn::Open});
    return program ? std::move(program).value() : machine::Program{};
}

} // namespace

Chart plainChart(int wales, int courses) {
    return twoBedChart(wales, courses, [](int, int) { return false; });
}

Chart ribChart(int wales, int courses, int knits, int purls) {
    return twoBedChart(wales, courses, [=](int wale, int) { return wale % (knits + purls) >= knits; });
}

Chart garterChart(int wales, int courses) {
    return twoBedChart(wales, courses, [](int, int course) { return course % 2 == 1; });
}

Chart seedChart(int wales, int courses) {
    return twoBedChart(wales, courses, [](int wale, int course) { return (wale + course) % 2 == 1; });
}

Chart mossChart(int wales, int courses) {
    return twoBedChart(wales, courses, [](int wale, int course) { return (wale + course / 2) % 2 == 1; });
}

machine::Program makePlain(int wales, int courses) {
    return withoutCastOn(plainChart(wales, courses));
}

machine::Program makeRib(int wales, int courses, int knits, int purls) {
    return withoutCastOn(ribChart(wales, courses, knits, purls));
}

machine::Program makeGarter(int wales, int courses) {
    return withoutCastOn(garterChart(wales, courses));
}

machine::Program makeSeed(int wales, int courses) {
    return withoutCastOn(seedChart(wales, courses));
}

machine::Program makeMoss(int wales, int courses) {
    return withoutCastOn(mossChart(wales, courses));
}

} // namespace knittsim::pattern
