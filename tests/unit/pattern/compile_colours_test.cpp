#include "knitted.h"

namespace knittsim::pattern {
namespace {

using machine::Direction;
using machine::Operation;
using machine::OperationKind;
using machine::Program;
using machine::Timeline;
using ::testing::ElementsAre;

TEST(FloatJacquard, EveryYarnPassesOnceAndEveryWaleTakesOneOfThem) {
    EXPECT_THAT(linesOf(compiled(chartOf({"kKKk", "KkkK"}))),
                ElementsAre("knit - f3 1", "knit - f2 1", "knit - f4 2", "knit - f1 2", "knit + f1 1",
                            "knit + f4 1", "knit + f2 2", "knit + f3 2"));
}

TEST(Intarsia, YarnTucksOnTheNextZoneBeforeThatZoneIsKnitted) {
    Chart chart = chartOf({"KKkk", "KKkk", "kkkk"});
    chart.course(1).colours = ColourMethod::Intarsia;
    chart.course(2).colours = ColourMethod::Intarsia;
    // Yarn 1 ends course 0 on the left, so that it meets the new yarn 2 going the other way.
    const Program program = compiled(chart);
    EXPECT_THAT(linesOf(program),
                ElementsAre("knit - f4 1", "knit - f3 1", "knit - f2 1", "knit - f1 1", "knit - f2 2",
                            "knit - f1 2", "knit + f3 1", "knit + f4 1", "knit - f4 1", "knit - f3 1",
                            "tuck - f2 1", "knit + f1 2", "knit + f2 2", "tuck + f3 2"));
    knitted(program);
}

TEST(Intarsia, CarriersThatGoTheSameWayJoinEveryCourse) {
    Chart chart = chartOf({"KKkk", "KKkk", "kkkk", "kkkk"});
    chart.course(2).colours = ColourMethod::Intarsia;
    chart.course(3).colours = ColourMethod::Intarsia;
    const Program program = compiled(chart);
    const std::vector<std::string> lines = linesOf(program);
    EXPECT_THAT(std::vector<std::string>(lines.begin() + 8, lines.end()),
                ElementsAre("knit - f4 1", "knit - f3 1", "tuck - f2 1", "knit - f2 2", "knit - f1 2",
                            "knit + f1 2", "knit + f2 2", "tuck + f3 2", "knit + f3 1", "knit + f4 1"));
    const Timeline timeline = knitted(program);
    // Needle 2 in course 2: the new yarn goes through the old loop and the tuck of the other yarn.
    EXPECT_EQ(timeline.loops().loops[11].parentCount, 2);
}

TEST(DoubleBeds, TubeCastsOnRoundAndKnitsRound) {
    Chart chart = chartOf({"ppp", "kkk"});
    chart.beds = BedUse::Double;
    EXPECT_THAT(linesOf(compiled(chart, {})),
                ElementsAre("tuck - f3 1", "tuck - f1 1", "tuck + b1 1", "tuck + b3 1", "tuck - f2 1",
                            "tuck + b2 1", "knit - f3 1", "knit - f2 1", "knit - f1 1", "knit + b1 1",
                            "knit + b2 1", "knit + b3 1"));
    knitted(compiled(chart, {}));
}

TEST(DoubleBeds, AllNeedleRibZigzagsAtAQuarterPitch) {
    Chart chart = chartOf({"bb", "bb"});
    chart.beds = BedUse::Double;
    EXPECT_THAT(linesOf(compiled(chart)),
                ElementsAre("rack 0.25", "knit - b2 1", "knit - f2 1", "knit - b1 1", "knit - f1 1",
                            "knit + f1 1", "knit + b1 1", "knit + f2 1", "knit + b2 1", "rack 0"));
}

TEST(DoubleBeds, RackedRearNeedlesAreKnittedWhereTheyStand) {
    Chart chart = chartOf({"bb", "bb"});
    chart.beds = BedUse::Double;
    chart.course(1).rack = 1;
    const std::vector<std::string> lines = linesOf(compiled(chart));
    // Rear needle 1 stands at 2.25, between front needle 2 and rear needle 2 at 3.25.
    EXPECT_THAT(
        std::vector<std::string>(lines.begin() + 5, lines.end()),
        ElementsAre("rack 1.25", "knit + f1 1", "knit + f2 1", "knit + b1 1", "knit + b2 1", "rack 0"));
}

TEST(DoubleBeds, RackingBeyondTheMachineIsReported) {
    Chart chart = chartOf({"bb", "bb"});
    chart.beds = BedUse::Double;
    chart.course(1).rack = 9;
    const Result<Program> result = compile(chart);
    ASSERT_FALSE(result);
    EXPECT_EQ(result.diagnostics()[0].id, "KS0507");
}

} // namespace
} // namespace knittsim::pattern
