// What lies on a needle and what is drawn through what: stacks, plating, splits.

#include "core/fabric/depth_order.h"
#include "tests/support/build.h"

#include <gmock/gmock.h>

namespace knittsim::fabric {
namespace {

using test::build;
using test::pass;
using testing::ElementsAre;
using testing::IsEmpty;

std::vector<int> stackPlaces(const Fabric& fabric) {
    std::vector<int> places;
    for (const Loop& loop : fabric.loops) {
        places.push_back(loop.stackPlace);
    }
    return places;
}

/// "head 0", "foot 2", ... from back to front at the left hand side of a loop's heads.
std::vector<std::string> depthAtHeads(const Fabric& fabric, LoopIndex loop, ClaspLevel level) {
    const PointIndex head = fabric.loops[static_cast<std::size_t>(loop)].headLeft;
    std::vector<PointIndex> row;
    orderInDepth(fabric, fabric.points[static_cast<std::size_t>(head)].entry, level, row);
    std::vector<std::string> names;
    for (const PointIndex p : row) {
        const BondingPoint& point = fabric.points[static_cast<std::size_t>(p)];
        names.push_back((point.role == Role::Head ? "head " : "foot ") + std::to_string(point.loop));
    }
    return names;
}

std::vector<LoopIndex> through(const Fabric& fabric, LoopIndex loop) {
    const auto children = fabric.drawnThrough(loop);
    return {children.begin(), children.end()};
}

TEST(Depth, AFrontLoopComesFromBehindThenInFront) {
    const Fabric fabric = build("in 1\nknit + f0 1\nknit - f0 1\n");
    EXPECT_THAT(depthAtHeads(fabric, 0, ClaspLevel::Lower), ElementsAre("foot 1", "head 0"));
    EXPECT_THAT(depthAtHeads(fabric, 0, ClaspLevel::Upper), ElementsAre("head 0", "foot 1"));
}

TEST(Depth, ARearLoopIsItsMirrorImage) {
    const Fabric fabric = build("in 1\nknit + b0 1\nknit - b0 1\n");
    EXPECT_THAT(depthAtHeads(fabric, 0, ClaspLevel::Lower), ElementsAre("head 0", "foot 1"));
    EXPECT_THAT(depthAtHeads(fabric, 0, ClaspLevel::Upper), ElementsAre("foot 1", "head 0"));
}

TEST(Plating, TheLeadingYarnLiesOnTheTechnicalFace) {
    const Fabric fabric = build("in 1 2\nknit + f5 1 2\nknit - f5 1 2\n");
    EXPECT_THAT((std::vector{fabric.loops[2].plating, fabric.loops[3].plating}), ElementsAre(0, 1));
    // From the back: yarn 2 behind yarn 1, in the old loop, in the new one, and at both crossings.
    EXPECT_THAT(depthAtHeads(fabric, 0, ClaspLevel::Lower),
                ElementsAre("foot 3", "foot 2", "head 1", "head 0"));
    EXPECT_THAT(depthAtHeads(fabric, 0, ClaspLevel::Upper),
                ElementsAre("head 1", "head 0", "foot 3", "foot 2"));
}

TEST(Plating, TheOrderOfTheCarriersIsKeptNotTheirNumbers) {
    const Fabric fabric = build("in 1 2\nknit + f5 2 1\nknit - f5 2 1\n");
    EXPECT_EQ(fabric.made.loops[2].carrier, 1);
    EXPECT_EQ(fabric.loops[2].plating, 0);
    EXPECT_THAT(depthAtHeads(fabric, 0, ClaspLevel::Upper),
                ElementsAre("head 1", "head 0", "foot 3", "foot 2"));
}

TEST(Plating, OnTheRearBedTheFaceIsTheBack) {
    const Fabric fabric = build("in 1 2\nknit + b5 1 2\nknit - b5 1 2\n");
    EXPECT_THAT(depthAtHeads(fabric, 0, ClaspLevel::Upper),
                ElementsAre("foot 2", "foot 3", "head 0", "head 1"));
}

TEST(Plating, ATransferDoesNotTurnTheYarnsRound) {
    // Made on the front bed with yarn 1 in front, knitted off on the rear bed: yarn 1 still lies in front.
    const Fabric fabric = build("in 1 2\nknit + f5 1 2\nxfer f5 b5\nknit - b5 1 2\n");
    EXPECT_THAT(depthAtHeads(fabric, 0, ClaspLevel::Lower),
                ElementsAre("head 1", "head 0", "foot 2", "foot 3"));
}

TEST(Stacks, ALoopThatArrivesLiesFartherFromTheBed) {
    const Fabric fabric = build("in 1\nknit + f0 1\nknit + f1 1\nxfer f1 b1\nrack -1\nxfer b1 f0\nrack 0\n");
    EXPECT_THAT(stackPlaces(fabric), ElementsAre(0, 1));
    EXPECT_THAT(depthAtHeads(fabric, 0, ClaspLevel::Lower), ElementsAre("head 1", "head 0"));
}

// Loop 1 lies behind loop 0 on f0; on the needle b0 it is then the one nearest to the bed.
TEST(Stacks, ATransferredStackKeepsItsOrderInSpace) {
    const std::string stacked = "in 1\nknit + f0 1\nknit + f1 1\nxfer f1 b1\nrack -1\nxfer b1 f0\nrack 0\n";
    const Fabric fabric = build(stacked + "xfer f0 b0\nknit - b0 1\n");
    EXPECT_THAT(stackPlaces(fabric), ElementsAre(1, 0, 0));
    EXPECT_THAT(fabric.made.parentsOf(2), ElementsAre(1, 0));
    EXPECT_THAT(depthAtHeads(fabric, 0, ClaspLevel::Lower), ElementsAre("head 1", "head 0", "foot 2"));
    const Fabric back = build(stacked + "xfer f0 b0\nxfer b0 f0\n");
    EXPECT_THAT(stackPlaces(back), ElementsAre(0, 1));
}

TEST(Stacks, TheOtherWayRoundIsAnotherFabric) {
    // Loop 0 goes to the rear bed first, and loop 1 comes onto it from the front.
    const Fabric fabric = build("in 1\nknit + f0 1\nknit + f1 1\nxfer f0 b0\nrack 1\nxfer f1 b0\nrack 0\n"
                                "knit - b0 1\n");
    EXPECT_THAT(fabric.made.parentsOf(2), ElementsAre(0, 1));
    EXPECT_THAT(depthAtHeads(fabric, 0, ClaspLevel::Lower), ElementsAre("head 0", "head 1", "foot 2"));
}

TEST(Stacks, TucksLieOnTopInTheOrderTheyCame) {
    const Fabric fabric = build("in 1\nknit + f0 1\ntuck - f0 1\ntuck + f0 1\nknit - f0 1\n");
    EXPECT_THAT(fabric.made.parentsOf(3), ElementsAre(0, 1, 2));
    EXPECT_THAT(stackPlaces(fabric), ElementsAre(0, 1, 2, 0));
    for (const LoopIndex loop : {0, 1, 2}) {
        EXPECT_THAT(through(fabric, loop), ElementsAre(3));
    }
    EXPECT_THAT(depthAtHeads(fabric, 0, ClaspLevel::Upper),
                ElementsAre("head 2", "head 1", "head 0", "foot 3"));
}

TEST(Splits, TheNewLoopIsDrawnThroughTheOldOneThatGoesOn) {
    const Fabric fabric = build("in 1\nknit + f0 1\nsplit - f0 b0 1\n");
    EXPECT_THAT(through(fabric, 0), ElementsAre(1));
    EXPECT_TRUE(fabric.loops[0].onNeedle);
    EXPECT_EQ(fabric.loops[0].end, Loop::End::Bound);
    EXPECT_EQ(fabric.loops[0].bound, (Needle{machine::Bed::Rear, 0}));
    EXPECT_TRUE(fabric.loops[1].onNeedle);
}

TEST(Splits, TheOldLoopIsBoundTwiceFromTheFootUp) {
    const Fabric fabric = build("in 1\nknit + f0 1\nsplit - f0 b0 1\nknit + b0 1\nknit - f0 1\n");
    EXPECT_THAT(through(fabric, 0), ElementsAre(1, 2)) << "the split loop below, the loop of b0 above";
    EXPECT_THAT(through(fabric, 1), ElementsAre(3));
    EXPECT_EQ(fabric.loops[0].bound, (Needle{machine::Bed::Rear, 0}));
    // Drawn to the front by f0 and to the back by b0.
    EXPECT_THAT(depthAtHeads(fabric, 0, ClaspLevel::Lower), ElementsAre("foot 1", "head 0", "foot 2"));
    EXPECT_THAT(depthAtHeads(fabric, 0, ClaspLevel::Upper), ElementsAre("foot 2", "head 0", "foot 1"));
}

TEST(Splits, AStackSplitsTogetherOntoWhatIsThere) {
    const Fabric fabric =
        build("in 1\nin 2\nknit + f0 1\ntuck - f0 1\nknit + b0 2\nsplit + f0 b0 1\nknit - b0 2\n");
    EXPECT_THAT(through(fabric, 0), ElementsAre(3, 4));
    EXPECT_THAT(through(fabric, 1), ElementsAre(3, 4));
    EXPECT_THAT(through(fabric, 2), ElementsAre(4));
    EXPECT_THAT(fabric.made.parentsOf(4), ElementsAre(2, 1, 0)) << "from the rear bed to the front";
}

TEST(Splits, APlatedSplitDrawsBothYarnsThrough) {
    const Fabric fabric = build("in 1 2\nknit + f0 1 2\nsplit - f0 b0 1 2\n");
    EXPECT_THAT(through(fabric, 0), ElementsAre(2, 3));
    EXPECT_THAT(through(fabric, 1), ElementsAre(2, 3));
}

TEST(Splits, TheSplitLoopBarsTheWayBack) {
    // Loop 0 passes behind loop 1; after the split a loop is drawn through it below, so that going back makes
    // new crossings above.
    const std::string there = "in 1\nin 2\nknit + f0 1\nknit + f1 1\nxfer f0 b0\nrack 2\n";
    EXPECT_EQ(build(there).crossings.size(), 4U);
    EXPECT_TRUE(build(there + "rack 0\n").crossings.empty());
    const Fabric split = build(there + "split + b0 f2 2\nxfer f2 b0\nrack 0\n");
    EXPECT_GT(split.crossings.size(), 4U);
}

TEST(Splits, OnEmptyNeedlesItHangsALoop) {
    const Fabric fabric = build("in 1\nsplit + f0 b0 1\n");
    EXPECT_EQ(fabric.loops.size(), 1U);
    EXPECT_THAT(through(fabric, 0), IsEmpty());
    EXPECT_EQ(fabric.loops[0].footLeft, -1);
}

} // namespace
} // namespace knittsim::fabric
