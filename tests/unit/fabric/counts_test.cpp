#include "tests/support/build.h"

#include <gmock/gmock.h>

#include <cmath>
#include <numeric>

namespace knittsim::fabric {
namespace {

using test::build;
using test::pass;

std::string plain(int wales, int courses) {
    std::string lines = "in 1\n";
    for (int c = 0; c < courses; ++c) {
        for (int w = 0; w < wales; ++w) {
            lines += c % 2 == 0 ? "knit + f" + std::to_string(w) + " 1\n"
                                : "knit - f" + std::to_string(wales - 1 - w) + " 1\n";
        }
    }
    return lines;
}

// Meissner & Eberhardt 1998, fig. 6.
TEST(Counts, TwoStitchesAboveEachOther) {
    const Fabric fabric = build("in 1\nknit + f0 1\nknit - f0 1\n");
    ASSERT_EQ(fabric.courses.size(), 2U);
    EXPECT_EQ(fabric.courses[0].count, 2);
    EXPECT_EQ(fabric.courses[1].count, 4);
    EXPECT_EQ(fabric.entryCount, 4);
}

struct Size {
    int wales;
    int courses;
};

class PlainCounts : public testing::TestWithParam<Size> {};

TEST_P(PlainCounts, FollowTheFormula) {
    const auto [w, h] = GetParam();
    const Fabric fabric = build(plain(w, h));
    EXPECT_EQ(fabric.loops.size(), static_cast<std::size_t>(w * h));
    EXPECT_EQ(fabric.points.size(), static_cast<std::size_t>(2 * w * h + 2 * w * (h - 1)));
    EXPECT_EQ(fabric.entryCount, 2 * w * h);
    EXPECT_EQ(fabric.courseCount, h);
    EXPECT_TRUE(fabric.crossings.empty());
}

INSTANTIATE_TEST_SUITE_P(Sizes, PlainCounts,
                         testing::Values(Size{1, 1}, Size{1, 5}, Size{7, 1}, Size{3, 4}, Size{20, 31}));

TEST(Counts, FeetShareTheEntryOfTheHeadsBelow) {
    const Fabric fabric = build(plain(4, 3));
    for (std::size_t i = 0; i < fabric.loops.size(); ++i) {
        const auto parents = fabric.made.parentsOf(static_cast<LoopIndex>(i));
        const auto entry = [&](PointIndex p) { return fabric.points[static_cast<std::size_t>(p)].entry; };
        if (parents.empty()) {
            EXPECT_EQ(fabric.loops[i].footLeft, -1);
            continue;
        }
        const Loop& parent = fabric.loops[static_cast<std::size_t>(parents[0])];
        EXPECT_EQ(entry(fabric.loops[i].footLeft), entry(parent.headLeft));
        EXPECT_EQ(entry(fabric.loops[i].footRight), entry(parent.headRight));
    }
}

TEST(Counts, YarnIsConserved) {
    // 3 rows of 5 loops of 5 mm: the last two sinkers of a row and the turn are within the loops; nothing
    // floats.
    const machine::Timeline timeline = test::timeline(plain(5, 3));
    const Fabric fabric = buildFabric(timeline);
    ASSERT_EQ(fabric.yarns.size(), 1U);
    const double loop = timeline.profile().defaultLoopLengthMm;
    // The first loop has no sinker before it.
    EXPECT_NEAR(fabric.yarns[0].lengthMm, loop * (15 - kSinkerShare), 1e-9);
    const double sum = std::accumulate(fabric.lengths.begin(), fabric.lengths.end(), 0.0);
    // Before the first and after the last bonding point lies one leg each: a leg of a cast-on loop and none
    // at the end.
    EXPECT_NEAR(fabric.yarns[0].lengthMm - sum, loop * kLegShare, 1e-9);
}

TEST(Counts, AFloatFeedsTheNeedlesItPasses) {
    const machine::Timeline timeline = test::timeline("in 1\nknit + f0 1\nknit + f1 1\nknit + f6 1\n");
    const Fabric fabric = buildFabric(timeline);
    const double loop = timeline.profile().defaultLoopLengthMm;
    const double pitch = timeline.profile().pitchMm();
    // Head to head over a sinker: leg, sinker, leg; the float is four needles longer.
    EXPECT_NEAR(fabric.lengths[1], loop * (2 * kLegShare + kSinkerShare), 1e-9);
    EXPECT_NEAR(fabric.lengths[3], fabric.lengths[1] + 4 * pitch, 1e-9);
    EXPECT_NEAR(timeline.finalState().carriers[0].fedMm, 3 * loop + 4 * pitch, 1e-9);
}

TEST(Counts, AYarnThatChangesBedsTakesTheGapToo) {
    const machine::Timeline timeline =
        test::timeline("in 1\nknit + f0 1\nknit + b1 1\nknit + b2 1\nknit + f3 1\n");
    const Fabric fabric = buildFabric(timeline);
    const double sinker = fabric.lengths[3]; // b1 to b2, of one bed
    const double extra = std::hypot(timeline.profile().pitchMm(), timeline.profile().bedGapMm) -
                         timeline.profile().pitchMm();
    EXPECT_GT(extra, 1);
    EXPECT_NEAR(fabric.lengths[1], sinker + extra, 1e-9);
    EXPECT_NEAR(fabric.lengths[5], sinker + extra, 1e-9);
    EXPECT_NEAR(timeline.finalState().carriers[0].fedMm,
                4 * timeline.profile().defaultLoopLengthMm + 2 * extra, 1e-9);
}

TEST(Counts, AParkedYarnIsDrawnAsFarAsTheFabricGrows) {
    // Carrier 2 waits at the edge while carrier 1 knits four courses.
    std::string lines = "in 1\nin 2\n" + pass("knit", 'f', 0, 2, 2);
    lines += pass("knit", 'f', 0, 2, 1) + pass("knit", 'f', 2, 0, 1) + pass("knit", 'f', 0, 2, 1) +
             pass("knit", 'f', 2, 0, 1);
    const machine::Timeline timeline = test::timeline(lines + pass("knit", 'f', 2, 0, 2));
    const Fabric fabric = buildFabric(timeline);
    const double loop = timeline.profile().defaultLoopLengthMm;
    // The first loop has no sinker before it; from course 0 to course 5 the yarn passes four courses more
    // than a turn.
    EXPECT_NEAR(fabric.yarns[1].lengthMm, loop * (6 - kSinkerShare + 4 * kCourseShare), 1e-9);
}

TEST(Counts, StackedLoopsShareTheirHeads) {
    const Fabric fabric =
        build("in 1\nknit + f0 1\nknit + f1 1\nxfer f1 b1\nrack -1\nxfer b1 f0\nrack 0\nknit - f0 1\n");
    const auto entry = [&](PointIndex p) { return fabric.points[static_cast<std::size_t>(p)].entry; };
    EXPECT_EQ(entry(fabric.loops[0].headLeft), entry(fabric.loops[1].headLeft));
    EXPECT_EQ(entry(fabric.loops[0].headRight), entry(fabric.loops[1].headRight));
    EXPECT_EQ(entry(fabric.loops[2].footLeft), entry(fabric.loops[0].headLeft));
    EXPECT_EQ(fabric.entryCount, 4);
    EXPECT_EQ(fabric.at(entry(fabric.loops[2].footLeft)).size(), 3U);
}

TEST(Counts, TuckAddsALoopWithoutFeet) {
    const Fabric fabric = build("in 1\nknit + f0 1\ntuck - f0 1\nknit + f0 1\n");
    ASSERT_EQ(fabric.loops.size(), 3U);
    EXPECT_EQ(fabric.loops[1].footLeft, -1);
    EXPECT_EQ(fabric.points.size(), 2U + 2U + 4U);
    EXPECT_EQ(fabric.entryCount, 4);
    EXPECT_EQ(fabric.made.parentsOf(2).size(), 2U);
}

TEST(Counts, PlatedLoopsAreTwoYarnsThroughTheSameLoops) {
    const Fabric fabric = build("in 1 2\nknit + f0 1 2\nknit - f0 1 2\n");
    EXPECT_EQ(fabric.loops.size(), 4U);
    EXPECT_EQ(fabric.yarns.size(), 2U);
    EXPECT_EQ(fabric.entryCount, 4);
    EXPECT_TRUE(fabric.crossings.empty());
}

TEST(Counts, EveryPointIsListedAtItsEntryOnce) {
    const Fabric fabric = build(plain(6, 5));
    std::vector<int> seen(fabric.points.size(), 0);
    for (EntryIndex e = 0; e < fabric.entryCount; ++e) {
        for (const PointIndex p : fabric.at(e)) {
            EXPECT_EQ(fabric.points[static_cast<std::size_t>(p)].entry, e);
            ++seen[static_cast<std::size_t>(p)];
        }
    }
    EXPECT_THAT(seen, testing::Each(1));
}

TEST(Counts, HistoryNamesOperationAndNeedle) {
    const machine::Timeline timeline = test::timeline("in 1\nknit + f3 1\nknit - b7 1\n");
    const Fabric fabric = buildFabric(timeline);
    for (const BondingPoint& point : fabric.points) {
        const machine::Operation& op =
            timeline.program().operations[static_cast<std::size_t>(point.operation)];
        EXPECT_EQ(op.needle, point.needle);
    }
}

TEST(Counts, APrefixIsTheFabricOfThatMoment) {
    const machine::Timeline timeline = test::timeline(plain(5, 4));
    const Fabric half = buildFabric(timeline, 1 + 10);
    EXPECT_EQ(half.loops.size(), 10U);
    EXPECT_EQ(half.entryCount, 20);
    EXPECT_EQ(half.courseCount, 2);
    EXPECT_EQ(buildFabric(timeline, 0).points.size(), 0U);
}

TEST(Counts, AYarnThatIsThereFromTheStartIsLaidLikeAnyOther) {
    const Fabric fabric =
        build("x-yarn-in + f0 1\nknit + f1 1\nknit + f2 1\nx-yarn-in - f5 1\nknit - f4 1\n");
    EXPECT_EQ(fabric.yarns.size(), 2U);
    EXPECT_EQ(fabric.yarns[0].count, 4);
    EXPECT_EQ(fabric.yarns[1].count, 2);
}

TEST(Counts, DroppedLoopsAreMarked) {
    const Fabric fabric = build("in 1\nknit + f0 1\nknit + f1 1\ndrop f0\n");
    EXPECT_EQ(fabric.loops[0].end, Loop::End::Dropped);
    EXPECT_EQ(fabric.loops[1].end, Loop::End::Held);
}

TEST(Courses, TwoColoursOfAJacquardRowShareACourse) {
    const Fabric fabric = build("in 1\nin 2\n" + pass("knit", 'f', 0, 3, 1) + pass("knit", 'f', 2, 0, 1, 2) +
                                pass("knit", 'f', 1, 3, 2, 2) + pass("knit", 'f', 3, 0, 2));
    EXPECT_EQ(fabric.loops[4].course, 1);
    EXPECT_EQ(fabric.loops[6].course, 1);
    EXPECT_EQ(fabric.loops[8].course, 2);
}

TEST(Courses, AJoinTuckDoesNotLiftTheNextCourse) {
    std::string lines = "in 1\nin 2\n" + pass("knit", 'f', 0, 3, 1) + pass("knit", 'f', 7, 4, 2);
    for (int course = 1; course < 9; course += 2) {
        lines += pass("knit", 'f', 3, 0, 1) + "tuck + f3 2\n" + pass("knit", 'f', 4, 7, 2);
        lines += pass("knit", 'f', 0, 3, 1) + "tuck + f4 1\n" + pass("knit", 'f', 7, 4, 2);
    }
    const Fabric fabric = build(lines);
    EXPECT_EQ(fabric.courseCount, 9);
}

} // namespace
} // namespace knittsim::fabric
