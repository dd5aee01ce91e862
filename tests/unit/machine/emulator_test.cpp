#include "core/machine/emulator.h"
#include "tests/support/build.h"

#include <gmock/gmock.h>

namespace knittsim::machine {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

MachineState run(const std::string& lines) {
    return test::timeline(lines).finalState();
}

std::vector<std::string> findings(const std::string& lines) {
    std::vector<std::string> ids;
    const Timeline timeline = test::timeline(lines);
    for (const Diagnostic& diagnostic : timeline.diagnostics()) {
        ids.push_back(diagnostic.id + '@' + std::to_string(diagnostic.place.line));
    }
    return ids;
}

Needle f(int i) {
    return {Bed::Front, i};
}
Needle b(int i) {
    return {Bed::Rear, i};
}

TEST(Emulator, KnitDrawsThroughAllLoopsOfTheNeedle) {
    const Timeline timeline = test::timeline("in 1\nknit + f0 1\ntuck + f0 1\nknit - f0 1\nout 1\n");
    EXPECT_THAT(timeline.finalState().loopsOn(f(0)), ElementsAre(2));
    EXPECT_THAT(timeline.loops().parentsOf(2), ElementsAre(0, 1));
    EXPECT_THAT(timeline.loops().parentsOf(1), IsEmpty());
}

TEST(Emulator, TuckHangsItsLoopOnTop) {
    EXPECT_THAT(run("in 1\nknit + f0 1\ntuck + f0 1\n").loopsOn(f(0)), ElementsAre(0, 1));
}

TEST(Emulator, TransferStacksOnTopOfTheLoopsThere) {
    const MachineState state = run("in 1\nknit + f0 1\nknit + b0 1\nxfer f0 b0\n");
    EXPECT_THAT(state.loopsOn(f(0)), IsEmpty());
    EXPECT_THAT(state.loopsOn(b(0)), ElementsAre(1, 0));
}

// The loop nearest to the bed that gives lies farthest from the bed that takes.
TEST(Emulator, ATransferredStackKeepsItsOrderInSpace) {
    const std::string stack = "in 1\nknit + f0 1\ntuck - f0 1\ntuck + f0 1\n";
    EXPECT_THAT(run(stack).loopsOn(f(0)), ElementsAre(0, 1, 2));
    EXPECT_THAT(run(stack + "xfer f0 b0\n").loopsOn(b(0)), ElementsAre(2, 1, 0));
    EXPECT_THAT(run(stack + "xfer f0 b0\nxfer b0 f0\n").loopsOn(f(0)), ElementsAre(0, 1, 2));
    EXPECT_THAT(run(stack + "tuck - b0 1\nxfer f0 b0\n").loopsOn(b(0)), ElementsAre(3, 2, 1, 0));
}

TEST(Emulator, RearNeedleFacesItsNumberPlusRack) {
    // FORMATS of knitout: at racking 2, f3 faces b1.
    EXPECT_THAT(run("in 1\nknit + f3 1\nrack 2\nxfer f3 b1\n").loopsOn(b(1)), ElementsAre(0));
    EXPECT_THAT(findings("in 1\nknit + f3 1\nrack 2\nxfer f3 b3\nout 1\n"), ElementsAre("KS0206@6"));
    EXPECT_THAT(findings("in 1\nknit + f3 1\nrack 0.25\nxfer f3 b3\nout 1\n"), ElementsAre("KS0206@6"));
}

TEST(Emulator, AnImpossibleTransferLeavesTheLoops) {
    const MachineState state = run("in 1\nknit + f3 1\nxfer f3 f4\nxfer f3 b7\n");
    EXPECT_THAT(state.loopsOn(f(3)), ElementsAre(0));
    EXPECT_THAT(findings("in 1\nknit + f3 1\nxfer f3 f4\nout 1\n"), ElementsAre("KS0207@5"));
}

TEST(Emulator, SplitMovesTheOldLoopsAndKeepsTheNewOne) {
    const Timeline timeline = test::timeline("in 1\nknit + f0 1\nknit + b0 1\nsplit - f0 b0 1\nout 1\n");
    EXPECT_THAT(timeline.finalState().loopsOn(f(0)), ElementsAre(2));
    EXPECT_THAT(timeline.finalState().loopsOn(b(0)), ElementsAre(1, 0));
    EXPECT_THAT(timeline.loops().parentsOf(2), ElementsAre(0));
    EXPECT_THAT(timeline.diagnostics(), IsEmpty());
}

TEST(Emulator, CarriersMoveAlongWithTheLoopsTheyHangOn) {
    const MachineState state = run("in 1\nknit + f3 1\nxfer f3 b3\n");
    EXPECT_EQ(state.carriers[0].place.needle, b(3));
    EXPECT_EQ(state.carriers[0].place.side, Direction::Right);
    const MachineState split = run("in 1\nin 2\nknit + f3 1\nsplit + f3 b3 2\n");
    EXPECT_EQ(split.carriers[0].place.needle, b(3)) << "the other carrier goes with the old loop";
    EXPECT_EQ(split.carriers[1].place.needle, f(3));
}

TEST(Emulator, RackingDoesNotMoveCarriers) {
    const MachineState state = run("in 1\nknit + b3 1\nrack 2\n");
    EXPECT_EQ(state.carriers[0].place.needle, b(3));
    EXPECT_DOUBLE_EQ(state.carriers[0].place.pitches, 3);
}

TEST(Emulator, DropEmptiesTheNeedle) {
    EXPECT_THAT(run("in 1\nknit + f0 1\ndrop f0\n").loopsOn(f(0)), IsEmpty());
}

TEST(Emulator, SlidersHoldTransferredLoops) {
    const Bed slider = Bed::RearSlider;
    EXPECT_THAT(run("in 1\nknit + f0 1\nxfer f0 bs0\n").loopsOn({slider, 0}), ElementsAre(0));
    EXPECT_THAT(findings("in 1\nknit + fs0 1\nout 1\n"), ElementsAre("KS0209@4"));
}

TEST(Emulator, NegativeNeedlesWork) {
    EXPECT_THAT(run("in 1\nknit + f-3 1\nrack -2\nxfer f-3 b-1\n").loopsOn(b(-1)), ElementsAre(0));
}

TEST(Emulator, SplitWithoutYarnIsATransfer) {
    EXPECT_THAT(run("in 1\nknit + f0 1\nsplit + f0 b0\n").loopsOn(b(0)), ElementsAre(0));
}

TEST(Emulator, CarrierFaultsAreFoundAtTheirLine) {
    EXPECT_THAT(findings("knit + f0 2\nknit + f1 2\nout 2\n"), ElementsAre("KS0201@3"))
        << "once, not for each stitch";
    EXPECT_THAT(findings("in 1\nin 1\nout 1\n"), ElementsAre("KS0202@4"));
    EXPECT_THAT(findings("out 1\n"), ElementsAre("KS0203@3"));
    EXPECT_THAT(findings("inhook 1\ninhook 2\nreleasehook 2\nout 1 2\n"), ElementsAre("KS0204@4"));
    EXPECT_THAT(findings("inhook 1\nreleasehook 2\nout 1\n"), ElementsAre("KS0205@4"));
    EXPECT_THAT(findings("in 1\nknit + f0 1\n"), ElementsAre("KS0210@4"));
}

TEST(Emulator, FarNeedlesAreRefusedSoThatMemoryStaysBounded) {
    EXPECT_THAT(findings("in 1\nknit + f999999 1\nout 1\n"), ElementsAre("KS0208@4"));
    EXPECT_EQ(run("in 1\nknit + f999999 1\nout 1\n").loopCount, 0);
}

TEST(Emulator, StitchNumbersSetTheLoopLength) {
    const Timeline timeline =
        test::timeline("in 1\nx-stitch-number 0\nknit + f0 1\nx-stitch-number 120\nknit + f1 1\n");
    const MachineProfile profile = genericProfile();
    EXPECT_DOUBLE_EQ(timeline.loops().loops[0].lengthMm, profile.stitchTable.front().second);
    EXPECT_DOUBLE_EQ(timeline.loops().loops[1].lengthMm, profile.stitchTable.back().second);
}

TEST(Emulator, YarnPlacedWithoutCastOnStandsWhereItSays) {
    const MachineState state = run("x-yarn-in + f4 1\n");
    EXPECT_TRUE(state.carriers[0].in);
    EXPECT_EQ(state.carriers[0].place.needle, f(4));
}

TEST(Emulator, ArcLengthsOfAYarnFollowEachOther) {
    const Timeline timeline = test::timeline("in 1\n" + test::pass("knit", 'f', 0, 9, 1) + "miss + f15 1\n" +
                                             test::pass("knit", 'f', 9, 0, 1));
    double end = 0;
    for (const Loop& loop : timeline.loops().loops) {
        EXPECT_GE(loop.yarnBeginMm, end);
        EXPECT_DOUBLE_EQ(loop.yarnEndMm - loop.yarnBeginMm, loop.lengthMm);
        end = loop.yarnEndMm;
    }
    EXPECT_DOUBLE_EQ(timeline.finalState().carriers[0].fedMm, end);
    EXPECT_DOUBLE_EQ(timeline.loops().loops[10].wayPitches, 12) << "six needles out and six back";
}

} // namespace
} // namespace knittsim::machine
