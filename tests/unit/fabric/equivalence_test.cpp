// Programs that make the same fabric, and some that look as if they did. Where two programs are equivalent in
// Lin, Narayanan, Ikarashi, Ragan-Kelley, Bernstein, McCann, "Semantics and Scheduling for Machine Knitting
// Compilers" (SIGGRAPH 2023) - their tangles can be moved into each other - they must be so here.

#include "core/fabric/layers.h"
#include "tests/support/build.h"
#include "tests/support/fabric_form.h"

#include <gmock/gmock.h>

namespace knittsim::fabric {
namespace {

using test::build;
using test::FabricForm;
using test::formOf;
using test::pass;

std::string apart(const std::string& a, const std::string& b) {
    return difference(withSortedCrossings(formOf(build(a))), withSortedCrossings(formOf(build(b))));
}

/// Without the needles on which the machine did it.
std::string apartInHand(const std::string& a, const std::string& b) {
    return difference(withSortedCrossings(withoutMachine(formOf(build(a)))),
                      withSortedCrossings(withoutMachine(formOf(build(b)))));
}

const std::string kRow = "in 1\n" + pass("knit", 'f', 0, 4, 1);
const std::string kBack = pass("knit", 'f', 4, 0, 1);

TEST(Same, TransferThereAndBack) {
    // The loop comes back to where it was before anything passed it.
    EXPECT_EQ(apart(kRow + "xfer f2 b2\nxfer b2 f2\n" + kBack, kRow + kBack), "");
}

TEST(Same, RackWithNothingOnTheRearBed) {
    // There is no strand that moves.
    EXPECT_EQ(apart(kRow + "rack 3\n" + kBack + "rack 0\n", kRow + kBack), "");
}

TEST(Same, RackInOneGoAndInSteps) {
    // Only where the rear bed starts and ends counts.
    const std::string there = kRow + "xfer f1 b1\nxfer f3 b3\n";
    const std::string then = "xfer b1 f3\n" + pass("knit", 'f', 2, 4, 1);
    EXPECT_EQ(apart(there + "rack 2\n" + then, there + "rack 1\nrack -1\nrack 0.5\nrack 2\n" + then), "");
}

TEST(Same, TransfersOfDifferentNeedlesInAnyOrder) {
    // They happen at different places of the bed.
    EXPECT_EQ(apart(kRow + "xfer f1 b1\nxfer f3 b3\n" + kBack, kRow + "xfer f3 b3\nxfer f1 b1\n" + kBack),
              "");
}

TEST(Same, TwoYarnsAtDifferentPlacesInAnyOrder) {
    // Neither yarn comes to where the other one is.
    const std::string in = "in 1\nin 2\n";
    const std::string left = pass("knit", 'f', 0, 3, 1) + pass("knit", 'f', 3, 0, 1);
    const std::string right = pass("knit", 'f', 6, 9, 2) + pass("knit", 'f', 9, 6, 2);
    EXPECT_EQ(apart(in + left + right, in + right + left), "");
}

TEST(Same, TransferOfNothingAndDropOfNothing) {
    EXPECT_EQ(apart(kRow + "xfer b2 f2\nxfer f9 b9\ndrop b2\ndrop f9\n" + kBack, kRow + kBack), "");
}

TEST(Same, MissThereAndBack) {
    // The yarn passes loops and passes them back.
    EXPECT_EQ(apart(kRow + "miss - f0 1\nmiss + f4 1\n" + kBack, kRow + kBack), "");
}

TEST(Same, CastOnHereOrThere) {
    // A loop on an empty needle has no side; what counts is on which bed the next one is drawn through it.
    std::string rear = pass("knit", 'b', 4, 0, 1);
    const std::string toRear = "xfer f0 b0\nxfer f1 b1\nxfer f2 b2\nxfer f3 b3\nxfer f4 b4\n";
    EXPECT_EQ(apartInHand(kRow + toRear + rear, "in 1\n" + pass("knit", 'b', 0, 4, 1) + rear), "");
}

TEST(Same, AWholeFabricMovedToTheOtherBedShowsItsReverse) {
    // Knit, moved over and knitted there is the same as knit, turned round, knit, seen from one side: the
    // second course is pulled to the back. From behind it is a face stitch over a reverse one.
    const std::string toRear = "xfer f0 b0\nxfer f1 b1\nxfer f2 b2\nxfer f3 b3\nxfer f4 b4\n";
    const FabricForm garter = formOf(build(kRow + kBack + toRear + pass("knit", 'b', 0, 4, 1)));
    for (std::size_t i = 5; i < 15; ++i) {
        EXPECT_EQ(machine::isFront(garter.yarns[0].loops[i].needle.bed), i < 10);
    }
    const std::string toFront = "xfer b0 f0\nxfer b-1 f-1\nxfer b-2 f-2\nxfer b-3 f-3\nxfer b-4 f-4\n";
    const FabricForm fromBehind =
        formOf(build("in 1\n" + pass("knit", 'b', 0, -4, 1) + pass("knit", 'b', -4, 0, 1) + toFront +
                     pass("knit", 'f', 0, -4, 1)));
    EXPECT_EQ(difference(turnedOver(garter), fromBehind), "");
}

TEST(Same, KnitAndTuckAndSplitOnAnEmptyNeedle) {
    // All three hang a loop there.
    const std::string next = pass("knit", 'f', 3, 0, 1);
    const std::string knit = "in 1\n" + pass("knit", 'f', 0, 3, 1) + next;
    EXPECT_EQ(apartInHand("in 1\n" + pass("tuck", 'f', 0, 3, 1) + next, knit), "");
    EXPECT_EQ(apartInHand("in 1\nsplit + f0 b0 1\nsplit + f1 b1 1\nsplit + f2 b2 1\nsplit + f3 b3 1\n" + next,
                          knit),
              "");
}

TEST(Same, SplitWithoutYarnIsATransfer) {
    EXPECT_EQ(apart(kRow + "split - f2 b2\n" + kBack, kRow + "xfer f2 b2\n" + kBack), "");
}

TEST(Same, ATuckOnTheLoopAndATuckTransferredOntoIt) {
    // Either way it lies on top, nearer to the other bed.
    const std::string next = pass("knit", 'f', 4, 0, 1);
    EXPECT_EQ(apartInHand(kRow + "tuck - f4 1\n" + next, kRow + "tuck - b4 1\nxfer b4 f4\n" + next), "");
}

TEST(Same, AMoveByAnyRoute) {
    // The loop of f1 goes over the empty needle f3 past the loop of f2, behind it.
    const std::string row = "in 1\nknit + f1 1\nknit + f2 1\nknit + f6 1\n";
    const std::string direct = row + "xfer f1 b1\nrack 2\nxfer b1 f3\nrack 0\n";
    const std::string beyond = row + "xfer f1 b1\nrack 4\nrack 2\nxfer b1 f3\nrack 0\n";
    const std::string there = row +
                              "xfer f1 b1\nrack -1\nxfer b1 f0\nrack 0\nxfer f0 b0\nrack 3\nxfer b0 f3\n"
                              "rack 0\n";
    const std::string two = row + "xfer f1 b1\nrack 3\nxfer b1 f4\nrack 0\nxfer f4 b4\nrack -1\nxfer b4 f3\n"
                                  "rack 0\n";
    const std::string under = row + "rack 2\nrack 0\nxfer f1 b1\nrack 2\nxfer b1 f3\nxfer f3 b1\nxfer b1 f3\n"
                                    "rack 0\n";
    EXPECT_EQ(build(direct).crossings.size(), 4U);
    for (const std::string& route : {beyond, there, two, under}) {
        EXPECT_EQ(apart(direct, route), "") << route;
    }
}

TEST(Same, ACableUndoneTheSameWay) {
    const std::string toRear = "xfer f1 b1\nxfer f2 b2\n";
    const std::string left = toRear + "rack 1\nxfer b1 f2\nrack -1\nxfer b2 f1\nrack 0\n";
    const std::string back = toRear + "rack -1\nxfer b2 f1\nrack 1\nxfer b1 f2\nrack 0\n";
    EXPECT_EQ(build(kRow + left).crossings.size(), 4U);
    EXPECT_EQ(apart(kRow + left + back + kBack, kRow + kBack), "");
}

TEST(Same, LoopsOfOneStrandInAnyOrder) {
    // The two loops that go to the right in front come to their needles in either order.
    const std::string toRear = "xfer f0 b0\nxfer f1 b1\nxfer f2 b2\nxfer f3 b3\nrack 2\n";
    const std::string rest = "rack -2\nxfer b2 f0\nxfer b3 f1\nrack 0\n" + kBack;
    EXPECT_EQ(apart(kRow + toRear + "xfer b0 f2\nxfer b1 f3\n" + rest,
                    kRow + toRear + "xfer b1 f3\nxfer b0 f2\n" + rest),
              "");
}

// A tube on every needle and one on every other needle are one fabric: at half gauge the layers cross in the
// machine's view, but always the front one in front.
TEST(Same, AFullGaugeAndAHalfGaugeTube) {
    std::string full = "in 1\n";
    std::string half = "in 1\n";
    for (int round = 0; round < 3; ++round) {
        full += pass("knit", 'f', 0, 4, 1) + pass("knit", 'b', 4, 0, 1);
        half += pass("knit", 'f', 0, 8, 1, 2) + pass("knit", 'b', 9, 1, 1, 2);
    }
    EXPECT_EQ(difference(withoutMachine(formOf(build(full))),
                         withoutCrossings(withoutMachine(formOf(build(half))))),
              "");
    const Fabric fabric = build(half);
    std::vector<bool> front;
    for (const machine::Loop& loop : fabric.made.loops) {
        front.push_back(machine::isFront(loop.needle.bed));
    }
    EXPECT_TRUE(canBePulledApart(fabric, front));
}

TEST(NotSame, CablesToTheLeftAndToTheRight) {
    const std::string toRear = "xfer f1 b1\nxfer f2 b2\n";
    EXPECT_NE(apart(kRow + toRear + "rack 1\nxfer b1 f2\nrack -1\nxfer b2 f1\nrack 0\n",
                    kRow + toRear + "rack -1\nxfer b2 f1\nrack 1\nxfer b1 f2\nrack 0\n"),
              "");
}

TEST(NotSame, AFloatInFrontOfTheLoopAndBehindIt) {
    const std::string row = "in 1\nin 2\n" + pass("knit", 'f', 0, 4, 1) + "tuck + f-1 2\n";
    const std::string over = "tuck + f6 2\n";
    EXPECT_NE(apart(row + over, row + "xfer f2 b2\n" + over + "xfer b2 f2\n"), "");
}

TEST(NotSame, TheOrderOfAStack) {
    const std::string one = "xfer f1 b1\nrack 1\nxfer b1 f2\nrack 0\n";
    const std::string other = "xfer f2 b2\nxfer f1 b1\nrack 1\nxfer b1 f2\nrack 0\nxfer b2 f2\n";
    const std::string next = pass("knit", 'f', 4, 2, 1);
    EXPECT_NE(apart(kRow + one + next, kRow + other + next), "");
}

TEST(NotSame, TheOrderOfPlatedYarns) {
    EXPECT_NE(apart("in 1 2\nknit + f0 1 2\nknit - f0 1 2\n", "in 1 2\nknit + f0 1 2\nknit - f0 2 1\n"), "");
}

TEST(NotSame, KnitOnTheFrontAndOnTheRear) {
    EXPECT_NE(apartInHand(kRow + kBack, kRow + "xfer f2 b2\n" + pass("knit", 'f', 4, 3, 1) + "knit - b2 1\n" +
                                            pass("knit", 'f', 1, 0, 1)),
              "");
}

} // namespace
} // namespace knittsim::fabric
