#include "knitted.h"

namespace knittsim::pattern {
namespace {

using machine::Bed;
using machine::Loop;
using machine::LoopIndex;
using machine::Needle;
using machine::OperationKind;
using machine::Program;
using machine::Timeline;
using ::testing::ElementsAre;
using ::testing::IsSupersetOf;
using ::testing::SizeIs;

/// Needles on which the parents of a loop were made.
std::vector<std::string> parentNeedles(const Timeline& timeline, LoopIndex loop) {
    std::vector<std::string> needles;
    for (const LoopIndex parent : timeline.loops().parentsOf(loop)) {
        needles.push_back(toString(timeline.loops().loops[static_cast<std::size_t>(parent)].needle));
    }
    return needles;
}

std::string problemOf(const Chart& chart, const CompileOptions& options = {}) {
    const Result<Program> result = compile(chart, options);
    EXPECT_FALSE(result);
    return result ? "" : result.diagnostics()[0].id;
}

TEST(Compile, PlainGoesLeftThenRight) {
    EXPECT_THAT(linesOf(compiled(chartOf({"kk", "kk"}))),
                ElementsAre("knit - f2 1", "knit - f1 1", "knit + f1 1", "knit + f2 1"));
}

TEST(Compile, CarrierComesInWithTheHookAndLeavesAfterItsLastCourse) {
    const Program program = compiled(chartOf({"kk", "KK", "kk"}));
    std::vector<OperationKind> kinds;
    for (const machine::Operation& op : program.operations) {
        if (op.kind != OperationKind::Knit && op.kind != OperationKind::Colour) {
            kinds.push_back(op.kind);
        }
    }
    using enum OperationKind;
    EXPECT_THAT(kinds, ElementsAre(InHook, ReleaseHook, InHook, ReleaseHook, OutHook, OutHook));
    knitted(program);
}

TEST(Compile, MachineWithoutHookUsesTheGrippers) {
    CompileOptions options;
    options.machine.insertingHook = false;
    const Program program = compiled(chartOf({"kk", "kk"}), options);
    EXPECT_EQ(count(program, OperationKind::In), 1);
    EXPECT_EQ(count(program, OperationKind::Out), 1);
    EXPECT_EQ(count(program, OperationKind::InHook) + count(program, OperationKind::ReleaseHook), 0);
}

TEST(Compile, HeaderNamesMachineGaugeCarriersAndYarns) {
    Chart chart = chartOf({"kk"});
    chart.yarns[0] = {"3", {0xab, 0xcd, 0xef}, "merino-2-30"};
    const Program program = compiled(chart);
    EXPECT_EQ(program.header.machine, "generic-e15");
    EXPECT_EQ(program.header.gauge, 15);
    EXPECT_THAT(program.header.carriers, SizeIs(10));
    EXPECT_EQ(program.header.carriers[2].yarn, "merino-2-30");
    EXPECT_EQ(program.operations[0].kind, OperationKind::Colour);
    EXPECT_EQ(program.texts.at(0), "#abcdef");
}

TEST(Compile, AlternatingCastOnTucksEveryNeedleOnceOnItsOwnBed) {
    const std::vector<std::string> lines = linesOf(compiled(chartOf({"kpkp"}), {}));
    const std::vector<std::string> castOn(lines.begin(), lines.begin() + 4);
    EXPECT_THAT(castOn, ElementsAre("tuck - b4 1", "tuck - b2 1", "tuck + f1 1", "tuck + f3 1"));
    EXPECT_EQ(lines[4], "knit - b4 1");
    knitted(compiled(chartOf({"kpkp"}), {}));
}

TEST(Compile, LoopChangesBedsOnlyWhereItsNextStitchAsksForIt) {
    EXPECT_THAT(linesOf(compiled(chartOf({"ppk", "kpk"}))),
                ElementsAre("knit - f3 1", "knit - b2 1", "knit - f1 1", "xfer f1 b1", "knit + b1 1",
                            "knit + b2 1", "knit + f3 1"));
}

TEST(Compile, HeldLoopStaysOnItsBed) {
    // The rear loop is tucked and missed on the rear bed, then brought to the front for a knit stitch.
    EXPECT_THAT(linesOf(compiled(chartOf({"k", "m", "t", "p"}))),
                ElementsAre("knit - b1 1", "tuck + b1 1", "miss - b1 1", "xfer b1 f1", "knit + f1 1"));
}

TEST(Compile, CableRacksTheFrontGroupFirst) {
    Chart chart = chartOf({"kkkk", "kkkk"});
    chart.course(1).moves = cross(0, 2, 2, Front::Right);
    const Program program = compiled(chart);
    const std::vector<std::string> lines = linesOf(program);
    ASSERT_THAT(lines, SizeIs(4 + 11 + 4));
    EXPECT_THAT(std::vector<std::string>(lines.begin() + 4, lines.begin() + 15),
                ElementsAre("xfer f3 b3", "xfer f4 b4", "xfer f1 b1", "xfer f2 b2", "rack -2", "xfer b3 f1",
                            "xfer b4 f2", "rack 2", "xfer b1 f3", "xfer b2 f4", "rack 0"));
    const Timeline timeline = knitted(program);
    // Course 1 runs to the right: loops 4 to 7 on needles 1 to 4, drawn through the loops that changed
    // places.
    EXPECT_THAT(parentNeedles(timeline, 4), ElementsAre("f3"));
    EXPECT_THAT(parentNeedles(timeline, 5), ElementsAre("f4"));
    EXPECT_THAT(parentNeedles(timeline, 6), ElementsAre("f1"));
    EXPECT_THAT(parentNeedles(timeline, 7), ElementsAre("f2"));
}

TEST(Compile, CableTakesAPurlWaleWithIt) {
    Chart chart = chartOf({"pkk", "kkp"});
    chart.course(1).moves = cross(0, 2, 1, Front::Left);
    const Timeline timeline = knitted(compiled(chart));
    // Loops 0..2 go left over needles 3..1; the wale of needle 3 ends as a purl on needle 1.
    EXPECT_THAT(parentNeedles(timeline, 3), ElementsAre("b3"));
    EXPECT_EQ(timeline.loops().loops[3].needle, (Needle{Bed::Rear, 1}));
    EXPECT_THAT(parentNeedles(timeline, 4), ElementsAre("f1"));
}

TEST(Compile, LaceStacksTheMovedLoopAndLeavesAnEyelet) {
    Chart chart = chartOf({"kkk", "kkk"});
    chart.course(1).moves = {{0, 1}};
    const Program program = compiled(chart);
    const std::vector<std::string> lines = linesOf(program);
    EXPECT_THAT(std::vector<std::string>(lines.begin() + 3, lines.begin() + 7),
                ElementsAre("xfer f1 b1", "rack 1", "xfer b1 f2", "rack 0"));
    const Timeline timeline = knitted(program);
    EXPECT_THAT(parentNeedles(timeline, 3), SizeIs(0)) << "the eyelet";
    EXPECT_THAT(parentNeedles(timeline, 4), ElementsAre("f2", "f1"));
    EXPECT_THAT(parentNeedles(timeline, 5), ElementsAre("f3"));
}

TEST(Compile, MoveOntoARearLoopBringsItToTheFront) {
    Chart chart = chartOf({"kk", "kp"});
    chart.course(1).moves = {{0, 1}};
    const Timeline timeline = knitted(compiled(chart));
    EXPECT_THAT(parentNeedles(timeline, 3), ElementsAre("b2", "f1"));
}

TEST(Compile, TuckedLoopIsKnittedTogetherWithItsTucks) {
    const Timeline timeline = knitted(compiled(chartOf({"kk", "kt", "kt", "kk"})));
    const LoopIndex last = timeline.finalState().loopsOn({Bed::Front, 2})[0];
    EXPECT_EQ(timeline.loops().loops[static_cast<std::size_t>(last)].parentCount, 3);
}

TEST(Compile, MissedLoopIsHeldOverTheCourse) {
    const Program program = compiled(chartOf({"kkk", "kmk", "kkk"}));
    EXPECT_EQ(count(program, OperationKind::Miss), 1);
    const Timeline timeline = knitted(program);
    EXPECT_THAT(timeline.loops().loops, SizeIs(8));
    const LoopIndex last = timeline.finalState().loopsOn({Bed::Front, 2})[0];
    EXPECT_THAT(timeline.loops().parentsOf(last), ElementsAre(1)) << "made in the first course";
}

TEST(Compile, ShortRowTurnsAtItsTuck) {
    EXPECT_THAT(linesOf(compiled(chartOf({"kkkk", "rrkk", "rtkk", "kkkk", "kkkk"}))),
                IsSupersetOf({"tuck - f2 1"}));
    const std::vector<std::string> lines =
        linesOf(compiled(chartOf({"kkkk", "rrkk", "rtkk", "kkkk", "kkkk"})));
    EXPECT_THAT(std::vector<std::string>(lines.begin() + 8, lines.begin() + 13),
                ElementsAre("knit - f4 1", "knit - f3 1", "tuck - f2 1", "knit + f3 1", "knit + f4 1"));
}

TEST(Compile, DroppedEndingEmptiesTheNeedles) {
    const Timeline timeline = knitted(compiled(chartOf({"kp"}), {.ending = Ending::Dropped}));
    EXPECT_THAT(timeline.finalState().loopsOn({Bed::Front, 1}), SizeIs(0));
    EXPECT_THAT(timeline.finalState().loopsOn({Bed::Rear, 2}), SizeIs(0));
    const Timeline held = knitted(compiled(chartOf({"kp"})));
    EXPECT_THAT(held.finalState().loopsOn({Bed::Rear, 2}), SizeIs(1));
}

TEST(Compile, StitchNumberIsWrittenWhereItChanges) {
    Chart chart = chartOf({"k", "k", "k", "k"});
    chart.course(1).stitchNumber = 70;
    chart.course(2).stitchNumber = 70;
    chart.course(3).stitchNumber = 60;
    EXPECT_THAT(linesOf(compiled(chart)), ElementsAre("knit - f1 1", "x-stitch-number 70", "knit + f1 1",
                                                      "knit - f1 1", "x-stitch-number 60", "knit + f1 1"));
}

TEST(Compile, TellsWhatCannotBeKnitted) {
    Chart carrier = chartOf({"k"});
    carrier.yarns[0].carrier = "77";
    EXPECT_EQ(problemOf(carrier), "KS0008");
    carrier.yarns[0].carrier = "2";
    EXPECT_EQ(problemOf(carrier), "KS0505");

    Chart empty = chartOf({"kkk", "kk."});
    empty.course(1).moves = {{2, 1}};
    EXPECT_EQ(problemOf(empty), "KS0506");

    Chart far = chartOf({"kkkkkkkkkk", "kkkkkkkkkk"});
    far.course(1).moves = {{0, 9}};
    EXPECT_EQ(problemOf(far), "KS0507");
    far.course(1).moves = {{0, 8}};
    EXPECT_TRUE(compile(far));

    EXPECT_EQ(problemOf(chartOf({"k.", "kk"})), "KS0508");
    EXPECT_EQ(problemOf(Chart()), "KS0501");
}

TEST(Compile, ProblemNamesCourseAndNeedle) {
    const Result<Program> result = compile(chartOf({"k.", "kk"}));
    ASSERT_FALSE(result);
    EXPECT_EQ(result.diagnostics()[0].place.course, 1);
    EXPECT_EQ(result.diagnostics()[0].place.needle, "f2");
}

} // namespace
} // namespace knittsim::pattern
