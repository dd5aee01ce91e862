#include "core/fabric/strand_tracker.h"
#include "tests/support/build.h"

#include <gmock/gmock.h>

#include <set>

namespace knittsim::fabric {
namespace {

using test::build;
using test::pass;
using testing::ElementsAre;

/// Ordered pairs (front loop, rear loop) of all crossings of legs.
std::multiset<std::pair<LoopIndex, LoopIndex>> loopPairs(const Fabric& fabric) {
    std::multiset<std::pair<LoopIndex, LoopIndex>> pairs;
    for (const Crossing& crossing : fabric.crossings) {
        pairs.emplace(fabric.points[static_cast<std::size_t>(crossing.over)].loop,
                      fabric.points[static_cast<std::size_t>(crossing.under)].loop);
    }
    return pairs;
}

const std::string kFour = "in 1\n" + pass("knit", 'f', 0, 3, 1);
const std::string kAllToRear = "xfer f0 b0\nxfer f1 b1\nxfer f2 b2\nxfer f3 b3\n";
const std::string kBackRow = pass("knit", 'f', 3, 0, 1);

/// Two loops change places with their two neighbours; the loops that come to the front first lie in front.
std::string cable(int rackFirst) {
    const bool right = rackFirst > 0;
    return kFour + kAllToRear + "rack " + std::to_string(rackFirst) + "\n" +
           (right ? "xfer b0 f2\nxfer b1 f3\n" : "xfer b2 f0\nxfer b3 f1\n") + "rack " +
           std::to_string(-rackFirst) + "\n" +
           (right ? "xfer b2 f0\nxfer b3 f1\n" : "xfer b0 f2\nxfer b1 f3\n") + "rack 0\n" + kBackRow;
}

TEST(Crossings, TwoByTwoCableHasSixteenWithTheMachinesFrontStrand) {
    const Fabric right = build(cable(2));
    ASSERT_EQ(right.crossings.size(), 16U);
    for (const auto& [over, under] : loopPairs(right)) {
        EXPECT_LT(over, 2);
        EXPECT_GE(under, 2);
    }
    for (const Crossing& crossing : right.crossings) {
        EXPECT_EQ(crossing.sign, 1) << "the front loops went to the right";
    }
}

TEST(Crossings, MirroredCableHasMirroredCrossings) {
    const auto right = loopPairs(build(cable(2)));
    std::multiset<std::pair<LoopIndex, LoopIndex>> mirrored;
    const Fabric left = build(cable(-2));
    for (const auto& [over, under] : loopPairs(left)) {
        mirrored.emplace(3 - over, 3 - under);
    }
    EXPECT_EQ(right, mirrored);
    for (const Crossing& crossing : left.crossings) {
        EXPECT_EQ(crossing.sign, -1);
    }
}

/// Pieces of `other` that a leg of `loop` crosses, along the yarn.
std::vector<Piece> crossedBy(const Fabric& fabric, LoopIndex loop, Piece leg, LoopIndex other) {
    std::vector<Piece> pieces;
    for (const BondingPoint& point : fabric.points) {
        if (point.role == Role::Crossing && point.loop == loop && point.piece == leg) {
            const Crossing& crossing = fabric.crossings[static_cast<std::size_t>(point.crossing)];
            const PointIndex across = point.front > 0 ? crossing.under : crossing.over;
            const BondingPoint& crossed = fabric.points[static_cast<std::size_t>(across)];
            if (crossed.loop == other) {
                pieces.push_back(crossed.piece);
            }
        }
    }
    return pieces;
}

// The yarn of a row to the right goes up the left legs and down the right ones. The loop that goes to the
// right meets the left leg of the other one first, on its way up.
TEST(Crossings, LegsCrossInTheOrderInWhichTheyMeet) {
    const Fabric fabric = build(cable(2));
    for (const LoopIndex over : {0, 1}) {
        for (const LoopIndex under : {2, 3}) {
            EXPECT_THAT(crossedBy(fabric, over, Piece::LeftLeg, under),
                        ElementsAre(Piece::LeftLeg, Piece::RightLeg));
            EXPECT_THAT(crossedBy(fabric, over, Piece::RightLeg, under),
                        ElementsAre(Piece::RightLeg, Piece::LeftLeg));
            EXPECT_THAT(crossedBy(fabric, under, Piece::LeftLeg, over),
                        ElementsAre(Piece::RightLeg, Piece::LeftLeg));
            EXPECT_THAT(crossedBy(fabric, under, Piece::RightLeg, over),
                        ElementsAre(Piece::LeftLeg, Piece::RightLeg));
        }
    }
}

// A loop that came to face another one from the left, and the loop drawn through it: to the right it passes,
// to the left it does not.
TEST(Crossings, ALoopDrawnThroughOneThatFacesAnotherStandsOnTheSameSide) {
    const std::string facing = "in 1\nin 2\nknit + f2 1\nknit + b0 2\nrack 2\nknit + b0 2\n";
    const auto passed = [&](const std::string& then) {
        return loopPairs(build(facing + then)).count({0, 2});
    };
    EXPECT_EQ(passed("rack 3\n"), 4U);
    EXPECT_EQ(passed("rack 1\n"), 0U);
}

TEST(Crossings, TransferThereAndBackLeavesNone) {
    EXPECT_TRUE(build(kFour + kAllToRear + "xfer b0 f0\nxfer b1 f1\nxfer b2 f2\nxfer b3 f3\n" + kBackRow)
                    .crossings.empty());
}

TEST(Crossings, RackThereAndBackLeavesNone) {
    EXPECT_TRUE(build(kFour +
                      "xfer f0 b0\nxfer f2 b2\nrack 3\nrack -2\nrack 0.25\nrack 0\nxfer b0 f0\nxfer b2 f2\n" +
                      kBackRow)
                    .crossings.empty());
}

TEST(Crossings, ACableUndoneTheWayItCameCancels) {
    const std::string there = kFour + "xfer f0 b0\nrack 2\n";
    EXPECT_EQ(build(there + "rack 2.25\n").crossings.size(), 8U) << "passes f1 and f2";
    EXPECT_TRUE(build(there + "rack 0\nxfer b0 f0\n" + kBackRow).crossings.empty());
}

TEST(Crossings, FacingLoopsHaveNotPassed) {
    const std::string facing = kFour + "xfer f0 b0\nrack 1\n";
    EXPECT_TRUE(build(facing).crossings.empty());
    EXPECT_TRUE(build(facing + "rack 0.5\n").crossings.empty());
    EXPECT_EQ(build(facing + "rack 1.25\n").crossings.size(), 4U);
}

TEST(Crossings, AFullTwistIsNotUndone) {
    // The loop passes behind its neighbour, both change beds, and it comes back in front of it.
    const Fabric fabric = build("in 1\n" + pass("knit", 'f', 0, 1, 1) +
                                "xfer f0 b0\nrack 2\nxfer b0 f2\nrack 0\nxfer f1 b1\nrack 2\nrack 0\n"
                                "xfer b1 f1\n");
    EXPECT_EQ(fabric.crossings.size(), 4U + 4U - 4U) << "the second loop passes behind and comes back";
    const Fabric twist =
        build("in 1\n" + pass("knit", 'f', 0, 1, 1) +
              "xfer f0 b0\nrack 2\nxfer b0 f2\nrack 0\nxfer f1 b1\nrack 2\nxfer b1 f3\nrack 0\n");
    EXPECT_EQ(twist.crossings.size(), 8U);
}

TEST(Crossings, AFloatRunsBetweenTheBeds) {
    // Carrier 2 floats from needle 0 to needle 3; needle 1 holds a front loop, needle 2 a rear loop.
    const Fabric fabric = build("in 1\nknit + f1 1\nknit + b2 1\nin 2\nknit + f0 2\nknit + f3 2\n");
    const auto pairs = loopPairs(fabric);
    EXPECT_EQ(pairs.count({0, 3}), 2U) << "front loop in front of the float";
    EXPECT_EQ(pairs.count({3, 1}), 2U) << "float in front of the rear loop";
    // The parked carrier 1 hangs behind needle 2; its yarn leads to no further loop.
    EXPECT_EQ(pairs.size(), 4U);
}

TEST(Crossings, AMissThereAndBackLeavesNone) {
    EXPECT_TRUE(build(kFour + "miss - f0 1\nmiss + f3 1\n" + kBackRow).crossings.empty());
}

TEST(Crossings, TubeLayersDoNotCross) {
    std::string lines = "in 1\n" + pass("knit", 'f', 0, 5, 1) + pass("knit", 'b', 5, 0, 1);
    lines += pass("knit", 'f', 0, 5, 1) + pass("knit", 'b', 5, 0, 1);
    EXPECT_TRUE(build(lines).crossings.empty());
}

TEST(Crossings, TheFrontRailLiesInFrontAtAnIntarsiaJoin) {
    // Carrier 1 (front rail) tucks on the neighbour's needle, past carrier 3 that stands there, and goes
    // back.
    const machine::Timeline timeline =
        test::timeline("in 1\nin 3\n" + pass("knit", 'f', 0, 2, 1) + pass("knit", 'f', 5, 3, 3) +
                       "tuck + f3 1\n" + pass("knit", 'f', 2, 0, 1) + pass("knit", 'f', 3, 5, 3));
    machine::Emulator emulator(timeline.program(), timeline.profile());
    StrandTracker tracker(emulator, timeline.program());
    while (!emulator.atEnd()) {
        emulator.step(&tracker);
    }
    const auto carrierOf = [&](Strand strand) {
        return emulator.loops().loops[static_cast<std::size_t>(tracker.loopAfterFloat(strand.index))].carrier;
    };
    int floatsThatCross = 0;
    for (const Passing& passing : tracker.book().passings()) {
        if (passing.over.kind == Strand::Kind::Float && passing.under.kind == Strand::Kind::Float) {
            EXPECT_EQ(carrierOf(passing.over), 0);
            EXPECT_EQ(carrierOf(passing.under), 2);
            EXPECT_FALSE(passing.undone) << "the tuck in between holds";
            ++floatsThatCross;
        }
    }
    EXPECT_EQ(floatsThatCross, 2);
}

TEST(Crossings, PlatedYarnsRunSideBySide) {
    EXPECT_TRUE(build("in 1 2\n" + std::string("knit + f0 1 2\nknit + f1 1 2\nknit + f2 1 2\nknit - f2 1 2\n"
                                               "knit - f1 1 2\nknit - f0 1 2\n"))
                    .crossings.empty());
}

// Carriers 1 and 3 knit together; carrier 2, on the rail between theirs, stands in their way.
TEST(Crossings, PlatedYarnsPassAnotherYarnEachOnItsRail) {
    const Fabric fabric = build("in 1 3\nin 2\ntuck + f0 1 3\ntuck + f4 2\ntuck + f8 1 3\ntuck - f2 2\n");
    const auto carrierOf = [&](PointIndex p) {
        const LoopIndex loop = fabric.points[static_cast<std::size_t>(p)].loop;
        return static_cast<int>(fabric.made.loops[static_cast<std::size_t>(loop)].carrier);
    };
    std::multiset<std::pair<int, int>> floats;
    for (const Crossing& crossing : fabric.crossings) {
        if (fabric.points[static_cast<std::size_t>(crossing.over)].piece == Piece::Float &&
            fabric.points[static_cast<std::size_t>(crossing.under)].piece == Piece::Float) {
            floats.emplace(carrierOf(crossing.over), carrierOf(crossing.under));
        }
    }
    EXPECT_THAT(floats, testing::UnorderedElementsAre(std::pair{0, 1}, std::pair{1, 2}));
}

TEST(Crossings, EveryCrossingIsOnePlaceOfTwoStrands) {
    const Fabric fabric = build(cable(2));
    for (std::size_t i = 0; i < fabric.crossings.size(); ++i) {
        const BondingPoint& over = fabric.points[static_cast<std::size_t>(fabric.crossings[i].over)];
        const BondingPoint& under = fabric.points[static_cast<std::size_t>(fabric.crossings[i].under)];
        EXPECT_EQ(over.entry, under.entry);
        EXPECT_EQ(over.front, 1);
        EXPECT_EQ(under.front, -1);
        EXPECT_EQ(fabric.at(over.entry).size(), 2U);
    }
}

TEST(Crossings, MachinePositionsAreFiniteAndDistinct) {
    const Fabric fabric = build(cable(2));
    std::set<std::tuple<double, double, double>> places;
    for (const Vec3& place : fabric.machinePositions) {
        EXPECT_TRUE(place.allFinite());
        places.emplace(place.x(), place.y(), place.z());
    }
    EXPECT_GT(places.size(), fabric.machinePositions.size() * 3 / 4);
}

} // namespace
} // namespace knittsim::fabric
