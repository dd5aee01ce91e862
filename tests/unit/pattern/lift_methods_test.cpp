#include "lifted_back.h"

#include <random>

/// Charts of every way to knit colours, with every stitch, come back as cells and not as kept operations.
namespace knittsim::pattern {
namespace {

struct Kind {
    std::string name;
    BedUse beds = BedUse::Single;
    std::vector<ColourMethod> methods;
    std::vector<Stitch> stitches;
};

class LiftMethods : public ::testing::TestWithParam<Kind> {};

std::vector<Kind> kinds() {
    using enum Stitch;
    using enum ColourMethod;
    const std::vector<Stitch> knitPurl{Knit, Knit, Purl};
    const std::vector<Stitch> single{Knit, Knit, Purl, Tuck, Miss, Rest};
    const std::vector<Stitch> all{Knit, Knit,     Knit,     Purl,     Purl,     Both,    Tuck,
                                  Miss, KnitTuck, TuckKnit, TuckBoth, RearTuck, RearMiss};
    const std::vector<Stitch> worked{Knit, Knit, Purl, Tuck, Miss}; // zones may pass between short rows
    const std::vector<Stitch> noTuck{Knit, Knit, Purl, Both, Miss, RearMiss};
    return {
        {"OneBedFloat", BedUse::Single, {Float}, single},
        {"OneBedIntarsia", BedUse::Single, {Intarsia}, worked},
        {"OneBedBothMethods", BedUse::Single, {Float, Intarsia}, worked},
        {"TwoBedsFloat", BedUse::Double, {Float}, all},
        {"TwoBedsIntarsia", BedUse::Double, {Intarsia}, noTuck}, // a tuck may be the join of two zones
        {"TwoBedsBirdseye", BedUse::Double, {Birdseye}, all},
        {"TwoBedsLadderBack", BedUse::Double, {LadderBack}, all},
        {"TwoBedsWithAndWithoutBack", BedUse::Double, {Float, Birdseye, LadderBack}, all},
        {"TwoBedsAllMethodsKnitAndPurl", BedUse::Double, {Float, Intarsia, Birdseye, LadderBack}, knitPurl},
    };
}

INSTANTIATE_TEST_SUITE_P(Of, LiftMethods, ::testing::ValuesIn(kinds()),
                         [](const auto& info) { return info.param.name; });

Chart randomChart(std::mt19937& random, const Kind& kind) {
    const auto upTo = [&](int most) { return std::uniform_int_distribution<int>(0, most)(random); };
    const auto oneOf = [&](const auto& list) {
        return list[static_cast<std::size_t>(upTo(static_cast<int>(list.size()) - 1))];
    };
    Chart chart(6 + upTo(10), 3 + upTo(8));
    chart.beds = kind.beds;
    chart.yarns = {{"1", {}, ""}, {"2", {}, ""}, {"3", {}, ""}, {"4", {}, ""}};
    const int colours = upTo(3);
    for (int c = 0; c < chart.height(); ++c) {
        chart.course(c).colours = oneOf(kind.methods);
        for (int w = 0; w < chart.width; ++w) {
            const bool same = w > 0 && upTo(2) > 0; // patches of colour
            chart.at(w, c) = {c == 0 ? Stitch::Knit : oneOf(kind.stitches),
                              same ? chart.at(w - 1, c).yarn : static_cast<std::uint8_t>(upTo(colours))};
        }
    }
    return chart;
}

/// The first course is knitted, and there is yarn in every course: of others a program does not tell.
bool isTold(const Chart& chart) {
    bool told = true;
    for (int c = 0; c < chart.height(); ++c) {
        told = told && !yarnsOf(chart, c).empty();
    }
    for (int w = 0; w < chart.width; ++w) {
        told = told && chart.at(w, 0).stitch == Stitch::Knit;
    }
    return told;
}

/// What is wrong with the lifted chart, or nothing. On two beds different cells may be one program (a rear
/// stitch of the cell or of the back): the program must be the same.
std::string comesBackWhole(const Chart& chart) {
    const auto program = compile(chart);
    if (!program || !isTold(chart)) {
        return {}; // of a chart that is being shrunk
    }
    const auto yarns = machine::carrierYarns(program.value(), yarn::YarnLibrary({}), yarn::defaultYarn());
    const auto back = lift(program.value(), machine::genericProfile(), yarns);
    if (!back) {
        return "not lifted: " + back.diagnostics()[0].id;
    }
    const Project& project = back.value().project;
    const std::string same = difference(chart, back.value());
    if (back.value().kept > 0 || (chart.beds == BedUse::Single && !same.empty())) {
        return same;
    }
    const auto again = compile(project.chart, {.castOn = project.castOn, .ending = project.ending});
    return again && linesOf(again.value()) == linesOf(program.value()) ? "" : "another program";
}

TEST_P(LiftMethods, EveryCourseIsCells) {
    std::mt19937 random(5);
    for (int i = 0; i < 200 && !testing::Test::HasFailure(); ++i) {
        expectNone(randomChart(random, GetParam()), comesBackWhole, i);
    }
}

} // namespace
} // namespace knittsim::pattern
