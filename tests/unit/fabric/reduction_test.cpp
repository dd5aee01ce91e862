#include "core/fabric/reduction.h"
#include "tests/support/build.h"
#include "tests/support/random_program.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <numeric>

namespace knittsim::fabric {
namespace {

using test::build;
using test::pass;
using testing::ElementsAre;
using testing::UnorderedElementsAre;

/// Four wales, four courses; carrier 1 back and forth.
std::string swatch() {
    return "in 1\n" + pass("knit", 'f', 0, 3, 1) + pass("knit", 'f', 3, 0, 1) + pass("knit", 'f', 0, 3, 1) +
           pass("knit", 'f', 3, 0, 1);
}

EntryIndex entry(const Fabric& fabric, PointIndex point) {
    return fabric.points[static_cast<std::size_t>(point)].entry;
}

TEST(Runs, AHeldFabricHasNone) {
    EXPECT_TRUE(findRuns(build(swatch())).steps.empty());
}

TEST(Runs, ADroppedLoopRunsDownItsWale) {
    // Needle 1 holds loop 14 of the last course (12..15 lie on needles 3..0); below it 9, 6 and 1.
    const Runs runs = findRuns(build(swatch() + "drop f1\n"));
    EXPECT_THAT(runs.steps, ElementsAre(ElementsAre(14), ElementsAre(9), ElementsAre(6), ElementsAre(1)));
    EXPECT_EQ(runs.loopCount(), 4U);
}

TEST(Runs, WithoutTheHolderTheFabricRavelsFromTheTop) {
    const Runs runs = findRuns(build(swatch()), {.stitchHolder = false});
    ASSERT_EQ(runs.steps.size(), 4U);
    EXPECT_THAT(runs.steps[0], UnorderedElementsAre(12, 13, 14, 15));
    EXPECT_THAT(runs.steps[3], UnorderedElementsAre(0, 1, 2, 3));
}

TEST(Runs, ALoopDrawnThroughTwoReleasesBoth) {
    const Runs runs =
        findRuns(build("in 1\nknit + f0 1\nknit + f1 1\nxfer f1 b1\nrack -1\nxfer b1 f0\nrack 0\n"
                       "knit - f0 1\ndrop f0\n"));
    EXPECT_THAT(runs.steps, ElementsAre(ElementsAre(2), UnorderedElementsAre(0, 1)));
}

TEST(Runs, ASplitLoopHoldsTheOldOneOnlyTogetherWithItsNeedle) {
    const std::string split = "in 1\nknit + f0 1\nsplit - f0 b0 1\n";
    EXPECT_THAT(findRuns(build(split + "drop f0\n")).steps, ElementsAre(ElementsAre(1)))
        << "the old loop still hangs on b0";
    EXPECT_THAT(findRuns(build(split + "drop f0\ndrop b0\n")).steps,
                ElementsAre(ElementsAre(1), ElementsAre(0)));
}

TEST(Reduction, TakingNothingOutChangesNothing) {
    const Fabric before = build(swatch());
    const ReducedFabric after = removeRuns(before, {});
    EXPECT_EQ(after.fabric.points.size(), before.points.size());
    EXPECT_EQ(after.fabric.entryCount, before.entryCount);
    EXPECT_EQ(after.fabric.lengths, before.lengths);
    EXPECT_EQ(after.fabric.courses.size(), before.courses.size());
}

TEST(Reduction, ALadderTakesOutFourPointsALoop) {
    const Fabric before = build(swatch() + "drop f1\n");
    const ReducedFabric after = removeRuns(before, findRuns(before));
    EXPECT_EQ(after.fabric.points.size(), before.points.size() - 2 - 3 * 4) << "the cast-on loop has two";
    EXPECT_EQ(after.fabric.entryCount, before.entryCount - 8);
    EXPECT_EQ(after.fabric.loops[9].headLeft, -1);
}

TEST(Reduction, AStepTakesOutTheLoopsSoFar) {
    const Fabric before = build(swatch() + "drop f1\n");
    const ReducedFabric after = removeRuns(before, findRuns(before), 1);
    EXPECT_EQ(after.fabric.points.size(), before.points.size() - 4);
    EXPECT_EQ(after.fabric.loops[14].headLeft, -1);
    EXPECT_GE(after.fabric.loops[9].headLeft, 0);
}

TEST(Reduction, TheYarnOfALoopGoesInEqualPartsToItsNeighbours) {
    const Fabric before = build(swatch() + "drop f1\n");
    const Fabric after = removeRuns(before, findRuns(before), 1).fabric;
    const auto headArc = [](const Fabric& fabric, LoopIndex loop) {
        const Loop& l = fabric.loops[static_cast<std::size_t>(loop)];
        return fabric.lengths[static_cast<std::size_t>(std::min(l.headLeft, l.headRight))];
    };
    // A loop of 0.719 l takes 0.719 l / 2: all its parts become half as long again.
    EXPECT_NEAR(headArc(after, 13), 1.5 * headArc(before, 13), 1e-9);
    EXPECT_NEAR(headArc(after, 15), 1.5 * headArc(before, 15), 1e-9);
    EXPECT_NEAR(headArc(after, 12), headArc(before, 12), 1e-9);
}

TEST(Reduction, AtTheEdgeTheOnlyNeighbourOfTheCourseTakesAll) {
    const Fabric before = build(swatch() + "drop f3\n");
    const Fabric after = removeRuns(before, findRuns(before), 1).fabric;
    const Loop& neighbour = before.loops[13];
    const Loop& now = after.loops[13];
    const double was = before.lengths[static_cast<std::size_t>(neighbour.headRight)];
    EXPECT_NEAR(after.lengths[static_cast<std::size_t>(now.headRight)], 2 * was, 1e-9);
}

TEST(Reduction, ARungCrossesNothingOfTheRemovedLoop) {
    // A cable whose front loop is let go: its legs no longer cross anything.
    const std::string cable = "in 1\n" + pass("knit", 'f', 0, 1, 1) +
                              "xfer f0 b0\nxfer f1 b1\nrack 1\nxfer b0 f1\nrack -1\nxfer b1 f0\nrack 0\n";
    const Fabric before = build(cable);
    ASSERT_EQ(before.crossings.size(), 4U);
    const Fabric dropped = build(cable + "drop f1\n");
    const Fabric after = removeRuns(dropped, findRuns(dropped)).fabric;
    EXPECT_TRUE(after.crossings.empty());
}

TEST(Runs, GoOnFromAFabricThatIsPartlyReduced) {
    const Fabric before = build(swatch() + "drop f1\n");
    const Fabric half = removeRuns(before, findRuns(before), 2).fabric;
    EXPECT_THAT(findRuns(half).steps, ElementsAre(ElementsAre(6), ElementsAre(1)));
    const Fabric atOnce = removeRuns(before, findRuns(before)).fabric;
    const Fabric inTwo = removeRuns(half, findRuns(half)).fabric;
    EXPECT_EQ(inTwo.points.size(), atOnce.points.size());
    ASSERT_EQ(inTwo.lengths.size(), atOnce.lengths.size());
    for (std::size_t i = 0; i < atOnce.lengths.size(); ++i) {
        EXPECT_NEAR(inTwo.lengths[i], atOnce.lengths[i], 1e-9) << "between points " << i << " and " << i + 1;
    }
    EXPECT_TRUE(findRuns(inTwo).steps.empty());
}

TEST(Reduction, AFabricThatRavelsWhollyLeavesNothing) {
    const Fabric before = build(swatch());
    const ReducedFabric after = removeRuns(before, findRuns(before, {.stitchHolder = false}));
    EXPECT_TRUE(after.fabric.points.empty());
    EXPECT_EQ(after.fabric.entryCount, 0);
    EXPECT_TRUE(after.fabric.courses.empty());
}

TEST(Reduction, APlaceIsWhereItWasBefore) {
    const Fabric before = build(swatch() + "drop f1\n");
    const ReducedFabric after = removeRuns(before, findRuns(before));
    ASSERT_EQ(after.entryBefore.size(), static_cast<std::size_t>(after.fabric.entryCount));
    for (const LoopIndex loop : {0, 5, 13, 15}) {
        const auto was = before.loops[static_cast<std::size_t>(loop)].headLeft;
        const auto now = after.fabric.loops[static_cast<std::size_t>(loop)].headLeft;
        EXPECT_EQ(after.entryBefore[static_cast<std::size_t>(entry(after.fabric, now))], entry(before, was));
    }
}

TEST(Reduction, PositionsAreKeptFromStepToStep) {
    const Fabric before = build(swatch() + "drop f1\n");
    const Runs runs = findRuns(before);
    const ReducedFabric less = removeRuns(before, runs, 1);
    const ReducedFabric more = removeRuns(before, runs, 3);
    std::vector<float> places(3 * static_cast<std::size_t>(before.entryCount));
    std::iota(places.begin(), places.end(), 0.0F);
    const auto atOnce = pickPositions(more.entryBefore, places);
    const auto inSteps = pickPositions(pairEntries(more, less), pickPositions(less.entryBefore, places));
    EXPECT_EQ(atOnce.size(), 3 * static_cast<std::size_t>(more.fabric.entryCount));
    EXPECT_EQ(inSteps, atOnce);
}

class RandomReduction : public testing::TestWithParam<unsigned> {};

TEST_P(RandomReduction, YarnIsConservedAndNothingLooseIsLeft) {
    const Fabric before = buildFabric(machine::Timeline(
        test::randomProgram({.seed = GetParam(), .operations = 1500}), machine::genericProfile()));
    const Runs runs = findRuns(before);
    const Fabric after = removeRuns(before, runs).fabric;
    for (std::size_t y = 0; y < before.yarns.size(); ++y) {
        const auto total = [](const Fabric& fabric, const Yarn& yarn) {
            const auto first = fabric.lengths.begin() + yarn.first;
            return std::accumulate(first, first + yarn.count, 0.0);
        };
        EXPECT_LE(total(after, after.yarns[y]), before.yarns[y].lengthMm + 1e-6);
    }
    for (const double length : after.lengths) {
        ASSERT_GE(length, 0);
    }
    for (std::size_t i = 0; i < after.loops.size(); ++i) {
        if (after.loops[i].headLeft < 0) {
            continue;
        }
        for (const LoopIndex parent : after.made.parentsOf(static_cast<LoopIndex>(i))) {
            const Loop& below = after.loops[static_cast<std::size_t>(parent)];
            ASSERT_GE(below.headLeft, 0) << "a loop that holds keeps the loops it is drawn through";
            ASSERT_EQ(entry(after, after.loops[i].footLeft), entry(after, below.headLeft));
        }
    }
    for (const Crossing& crossing : after.crossings) {
        ASSERT_EQ(entry(after, crossing.over), entry(after, crossing.under));
    }
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomReduction, testing::Range(1U, 13U));

} // namespace
} // namespace knittsim::fabric
