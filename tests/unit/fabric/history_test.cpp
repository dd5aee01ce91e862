#include "core/fabric/fabric_builder.h"
#include "core/fabric/history.h"
#include "core/fabric/reduction.h"
#include "tests/support/build.h"
#include "tests/support/random_program.h"

#include <gmock/gmock.h>

#include <algorithm>

namespace knittsim::fabric {
namespace {

using machine::Bed;
using test::pass;
using test::timeline;
using testing::ElementsAre;
using testing::IsEmpty;
using Kind = HistoryEvent::Kind;

std::vector<Kind> kinds(const std::vector<HistoryEvent>& events) {
    std::vector<Kind> result;
    std::ranges::transform(events, std::back_inserter(result), &HistoryEvent::kind);
    return result;
}

// The two lines of the header come first: the n-th operation stands on line n + 3.
constexpr std::int32_t kFirstLine = 3;

TEST(LoopHistory, AKnitStitchIsMadeAndBound) {
    const auto machine = timeline("in 1\nknit + f0 1\nknit + f1 1\nknit - f1 1\nknit - f0 1\nknit + f0 1\n");
    const auto events = loopHistory(machine, 3); // the second loop on f0
    ASSERT_THAT(kinds(events), ElementsAre(Kind::Made, Kind::Bound));
    EXPECT_EQ(events[0].operation, 4);
    EXPECT_EQ(events[0].line, kFirstLine + 4);
    EXPECT_EQ(events[0].needle, (Needle{Bed::Front, 0}));
    EXPECT_THAT(events[0].others, ElementsAre(0));
    EXPECT_EQ(events[1].line, kFirstLine + 5);
    EXPECT_THAT(events[1].others, ElementsAre(4));
}

TEST(LoopHistory, EveryTransferIsTold) {
    const auto machine = timeline("in 1\nknit + f0 1\nknit + f1 1\n"
                                  "xfer f0 b0\nrack 1\nxfer b0 f1\nrack 0\nknit - f1 1\n");
    const auto events = loopHistory(machine, 0);
    ASSERT_THAT(kinds(events), ElementsAre(Kind::Made, Kind::Moved, Kind::Moved, Kind::Bound));
    EXPECT_EQ(events[1].needle, (Needle{Bed::Front, 0}));
    EXPECT_EQ(events[1].target, (Needle{Bed::Rear, 0}));
    EXPECT_THAT(events[1].others, IsEmpty());
    EXPECT_EQ(events[1].rack, 0);
    EXPECT_EQ(events[2].line, kFirstLine + 5);
    EXPECT_EQ(events[2].needle, (Needle{Bed::Rear, 0}));
    EXPECT_EQ(events[2].target, (Needle{Bed::Front, 1}));
    EXPECT_EQ(events[2].rack, 1);
    EXPECT_THAT(events[2].others, ElementsAre(1)) << "it comes onto the needle of its neighbour";
    EXPECT_EQ(events[3].needle, (Needle{Bed::Front, 1}));
    // The neighbour stays where it was and is bound by the same stitch.
    EXPECT_THAT(kinds(loopHistory(machine, 1)), ElementsAre(Kind::Made, Kind::Bound));
    // The new loop was drawn through both.
    EXPECT_EQ(loopHistory(machine, 2)[0].others.size(), 2U);
}

TEST(LoopHistory, EndsWithTheDropOrOnTheNeedle) {
    const auto machine = timeline("in 1\nknit + f0 1\nknit + f1 1\ndrop f0\nrack 1\n");
    const auto dropped = loopHistory(machine, 0);
    ASSERT_THAT(kinds(dropped), ElementsAre(Kind::Made, Kind::Dropped));
    EXPECT_EQ(dropped[1].operation, 3);
    const auto held = loopHistory(machine, 1);
    ASSERT_THAT(kinds(held), ElementsAre(Kind::Made, Kind::Held));
    EXPECT_EQ(held[1].operation, -1);
    EXPECT_EQ(held[1].needle, (Needle{Bed::Front, 1}));
    EXPECT_EQ(held[1].rack, 1);
    EXPECT_THAT(kinds(loopHistory(machine, 0, 3)), ElementsAre(Kind::Made, Kind::Held))
        << "before the drop it hung on its needle";
    EXPECT_THAT(loopHistory(machine, 0, 1), IsEmpty()) << "not made yet";
}

TEST(LoopHistory, ASplitBindsTheOldLoopAndMovesIt) {
    const auto machine = timeline("in 1\nknit + f0 1\nsplit - f0 b0 1\nknit + b0 1\n");
    const auto events = loopHistory(machine, 0);
    ASSERT_THAT(kinds(events), ElementsAre(Kind::Made, Kind::Bound, Kind::Moved, Kind::Bound));
    EXPECT_EQ(events[1].operation, events[2].operation);
    EXPECT_THAT(events[1].others, ElementsAre(1));
    EXPECT_THAT(events[3].others, ElementsAre(2));
    EXPECT_EQ(events[3].needle, (Needle{Bed::Rear, 0}));
}

TEST(LoopHistory, PlatedYarnsBindInOneEvent) {
    const auto machine = timeline("in 1\nin 2\nknit + f0 1\nknit - f0 1 2\n");
    const auto events = loopHistory(machine, 0);
    ASSERT_THAT(kinds(events), ElementsAre(Kind::Made, Kind::Bound));
    EXPECT_THAT(events[1].others, ElementsAre(1, 2));
}

TEST(PointHistory, AFootOfAFrontStitchLiesInFrontOfTheOldHead) {
    for (const char bed : {'f', 'b'}) {
        const auto machine = timeline("in 1\n" + pass("knit", bed, 0, 1, 1) + pass("knit", bed, 1, 0, 1));
        const Fabric fabric = buildFabric(machine);
        const Loop& upper = fabric.loops[3]; // on needle 0, through loop 0
        const PointHistory foot = pointHistory(fabric, machine, upper.footLeft);
        EXPECT_EQ(foot.loop, 3);
        EXPECT_EQ(foot.role, Role::Foot);
        EXPECT_EQ(foot.side, Side::Left);
        EXPECT_EQ(foot.inFront, bed == 'f' ? 3 : 0);
        EXPECT_EQ(pointHistory(fabric, machine, fabric.loops[0].headLeft).inFront, foot.inFront)
            << "the head below is the same place";
        EXPECT_EQ(pointHistory(fabric, machine, upper.headLeft).inFront, -1) << "nothing through it yet";
    }
}

/// Two loops that change places, the one from needle 0 in front.
std::string cable() {
    return "in 1\n" + pass("knit", 'f', 0, 1, 1) +
           "xfer f0 b0\nxfer f1 b1\nrack 1\nxfer b0 f1\nrack -1\nxfer b1 f0\nrack 0\n" +
           pass("knit", 'f', 1, 0, 1);
}

TEST(PointHistory, BothStrandsOfACrossingNameEachOtherAndWhoIsInFront) {
    const auto machine = timeline(cable());
    const Fabric fabric = buildFabric(machine);
    ASSERT_EQ(fabric.crossings.size(), 4U);
    for (const Crossing& crossing : fabric.crossings) {
        const PointHistory over = pointHistory(fabric, machine, crossing.over);
        const PointHistory under = pointHistory(fabric, machine, crossing.under);
        EXPECT_EQ(over.inFront, over.loop);
        EXPECT_EQ(under.inFront, over.loop);
        EXPECT_NE(over.loop, under.loop);
        EXPECT_EQ(over.partnerPiece, under.piece);
        EXPECT_EQ(under.partnerPiece, over.piece);
        for (const PointHistory* side : {&over, &under}) {
            const auto crossed = std::ranges::find(side->events, Kind::Crossed, &HistoryEvent::kind);
            ASSERT_NE(crossed, side->events.end());
            EXPECT_EQ(crossed->operation, crossing.operation);
            EXPECT_THAT(crossed->others, ElementsAre(side == &over ? under.loop : over.loop));
            EXPECT_TRUE(std::ranges::is_sorted(side->events.begin(), side->events.end() - 1, {},
                                               &HistoryEvent::operation));
        }
    }
}

TEST(PointHistory, IsTheSameAfterALadderIsTakenOut) {
    const auto machine =
        timeline("in 1\n" + pass("knit", 'f', 0, 3, 1) + pass("knit", 'f', 3, 0, 1) + "drop f1\n");
    const Fabric before = buildFabric(machine);
    const Fabric after = removeRuns(before, findRuns(before)).fabric;
    const PointIndex was = before.loops[7].headLeft;
    const PointIndex now = after.loops[7].headLeft;
    ASSERT_NE(was, now);
    EXPECT_EQ(pointHistory(after, machine, now).events, pointHistory(before, machine, was).events);
}

class RandomHistory : public testing::TestWithParam<unsigned> {};

/// What the books of the fabric say of a loop's end is what its history ends with.
TEST_P(RandomHistory, AgreesWithTheBooksOfTheFabric) {
    const machine::Timeline machine(test::randomProgram({.seed = GetParam(), .operations = 600}),
                                    machine::genericProfile());
    const Fabric fabric = buildFabric(machine);
    for (std::size_t i = 0; i < fabric.loops.size(); ++i) {
        const auto loop = static_cast<LoopIndex>(i);
        const auto events = loopHistory(machine, loop);
        ASSERT_FALSE(events.empty());
        EXPECT_EQ(events.front().kind, Kind::Made);
        EXPECT_EQ(events.front().operation, fabric.made.loops[i].operation);
        EXPECT_EQ(events.back().kind == Kind::Held, fabric.loops[i].onNeedle);
        Needle place = events.front().needle;
        for (const HistoryEvent& event : events) {
            ASSERT_EQ(event.needle, place) << "loop " << i;
            place = event.kind == Kind::Moved ? event.target : place;
        }
        if (fabric.loops[i].end != Loop::End::Bound) {
            EXPECT_EQ(place, fabric.loops[i].bound);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomHistory, testing::Range(1U, 7U));

} // namespace
} // namespace knittsim::fabric
