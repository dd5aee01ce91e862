#include "core/fabric/layers.h"
#include "tests/support/build.h"

#include <gmock/gmock.h>

namespace knittsim::fabric {
namespace {

using test::build;
using test::pass;

std::vector<bool> onFrontBed(const Fabric& fabric) {
    std::vector<bool> front;
    for (const machine::Loop& loop : fabric.made.loops) {
        front.push_back(machine::isFront(loop.needle.bed));
    }
    return front;
}

bool comesApart(const Fabric& fabric) {
    return canBePulledApart(fabric, onFrontBed(fabric));
}

int between(const Fabric& fabric) {
    return crossingsBetween(fabric, onFrontBed(fabric));
}

std::vector<bool> ofCarrier1(const Fabric& fabric) {
    std::vector<bool> front;
    for (const machine::Loop& loop : fabric.made.loops) {
        front.push_back(loop.carrier == 0);
    }
    return front;
}

/// Round and round: front bed to the right, rear bed to the left. `step` 2: on every other needle.
std::string tube(int rounds, int step) {
    std::string lines = "in 1\n";
    for (int i = 0; i < rounds; ++i) {
        lines += pass("knit", 'f', 0, 8, 1, step) + pass("knit", 'b', 7 + step, step - 1, 1, step);
    }
    return lines;
}

/// Where one yarn goes from one bed to the other.
std::vector<std::int32_t> turnNeedles(const Fabric& fabric) {
    std::vector<std::int32_t> needles;
    for (std::size_t i = 1; i < fabric.made.loops.size(); ++i) {
        if (fabric.made.loops[i].needle.bed != fabric.made.loops[i - 1].needle.bed) {
            needles.push_back(fabric.made.loops[i - 1].needle.index);
        }
    }
    return needles;
}

TEST(Layers, ATubeComesApartButForItsSides) {
    const Fabric fabric = build(tube(4, 1));
    EXPECT_TRUE(comesApart(fabric));
    EXPECT_EQ(between(fabric), 0);
    EXPECT_THAT(turnNeedles(fabric), testing::Each(testing::AnyOf(0, 8)));
}

TEST(Layers, AHalfGaugeTubeComesApart) {
    // Between its needles every front float passes a rear loop, in front of it, and the other way round.
    const Fabric fabric = build(tube(4, 2));
    EXPECT_TRUE(comesApart(fabric));
    EXPECT_GT(between(fabric), 0);
    EXPECT_THAT(turnNeedles(fabric), testing::Each(testing::AnyOf(1, 8)));
}

std::string twoSheets(int frontCarrier, int rearCarrier) {
    std::string lines = "in 1\nin 2\n";
    for (int i = 0; i < 3; ++i) {
        lines += pass("knit", 'f', 0, 8, frontCarrier) + pass("knit", 'b', 8, 0, rearCarrier);
        lines += pass("knit", 'f', 8, 0, frontCarrier) + pass("knit", 'b', 0, 8, rearCarrier);
    }
    return lines;
}

TEST(Layers, TwoYarnsMakeTwoPieces) {
    EXPECT_TRUE(comesApart(build(twoSheets(1, 2))));
}

TEST(Layers, YarnsThatChangeSidesOnTheirRailsHoldTheSheetsTogether) {
    // The front sheet's carrier runs behind the other one: where they pass each other, its yarn is caught.
    EXPECT_FALSE(comesApart(build(twoSheets(2, 1))));
}

TEST(Layers, ATuckOnTheOtherBedHoldsTheLayersTogether) {
    const std::string sheets = twoSheets(1, 2) + "tuck + b3 1\n";
    const std::string more = pass("knit", 'f', 4, 8, 1) + pass("knit", 'b', 8, 0, 2);
    const Fabric loose = build(twoSheets(1, 2) + more);
    EXPECT_TRUE(canBePulledApart(loose, ofCarrier1(loose)));
    const Fabric held = build(sheets + more);
    EXPECT_FALSE(canBePulledApart(held, ofCarrier1(held)));
}

TEST(Layers, ATransferOntoTheOtherBedJoinsThem) {
    EXPECT_FALSE(comesApart(build(tube(2, 1) + "xfer f3 b3\n")));
}

} // namespace
} // namespace knittsim::fabric
