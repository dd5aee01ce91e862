// Fractional racking: where a passing counts.

#include "tests/support/build.h"
#include "tests/support/shrink.h"

#include <gmock/gmock.h>

namespace knittsim::fabric {
namespace {

using test::build;
using testing::ElementsAre;

/// Loop 0 on front needle 5, loop 1 on rear needle 5, made at rack 0 facing each other; loops 2 and 3 on the
/// front needles beside. Nothing floats: every loop has its own carrier, which is taken out.
const std::string kFacing = "in 1\ntuck + f5 1\nout 1\nin 2\ntuck + b5 2\nout 2\nin 3\ntuck + f4 3\nout 3\n"
                            "in 4\ntuck + f6 4\nout 4\n";

/// (loop in front, loop behind, sign) of the crossings of left legs with left legs.
std::vector<std::tuple<LoopIndex, LoopIndex, int>> passings(const Fabric& fabric) {
    std::vector<std::tuple<LoopIndex, LoopIndex, int>> found;
    for (const Crossing& crossing : fabric.crossings) {
        const BondingPoint& over = fabric.points[static_cast<std::size_t>(crossing.over)];
        const BondingPoint& under = fabric.points[static_cast<std::size_t>(crossing.under)];
        if (over.piece == Piece::LeftLeg && under.piece == Piece::LeftLeg) {
            found.emplace_back(over.loop, under.loop, crossing.sign);
        }
    }
    return found;
}

class NothingPasses : public testing::TestWithParam<const char*> {};

TEST_P(NothingPasses, WhileTheRearLoopStaysBetweenItsNeighbours) {
    EXPECT_TRUE(build(kFacing + "rack " + GetParam() + "\n").crossings.empty());
}

INSTANTIATE_TEST_SUITE_P(Racks, NothingPasses,
                         testing::Values("0.25", "0.5", "0.75", "1", "-0.25", "-0.5", "-0.75", "-1"));

TEST(FractionalRacks, BeyondTheNeighbourItHasPassed) {
    EXPECT_THAT(passings(build(kFacing + "rack 1.25\n")), ElementsAre(std::tuple{3, 1, -1}))
        << "loop 3 on f6 in front; seen from loop 1 it goes to the left";
    EXPECT_THAT(passings(build(kFacing + "rack -1.25\n")), ElementsAre(std::tuple{2, 1, +1}));
}

// At rack 0.25 the rear loop stands to the right of the front loop with its number. What happens to the loops
// there makes that its place.
TEST(FractionalRacks, FromAQuarterToTheRightToAQuarterToTheLeftPassesTheFacingLoop) {
    const std::string quarter = "rack 0.25\nin 1\n";
    EXPECT_TRUE(build(quarter + "tuck + f5 1\ntuck + b5 1\nout 1\nrack 0\n").crossings.empty());
    const Fabric fabric = build(quarter + "tuck + f5 1\ntuck + b5 1\nout 1\nrack -0.25\n");
    EXPECT_THAT(passings(fabric), ElementsAre(std::tuple{0, 1, +1}));
    const Fabric mirror = build("rack -0.25\nin 1\ntuck - f5 1\ntuck - b5 1\nout 1\nrack 0.25\n");
    EXPECT_THAT(passings(mirror), ElementsAre(std::tuple{0, 1, -1}));
}

TEST(FractionalRacks, ThereAndBackComesToNothing) {
    const std::string quarter = "rack 0.25\nin 1\ntuck + f5 1\ntuck + b5 1\nout 1\n";
    EXPECT_TRUE(build(quarter + "rack -0.75\nrack 0.25\n").crossings.empty());
    EXPECT_TRUE(build(quarter + "rack 0\nrack 0.75\nrack -3.25\nrack 0.5\n").crossings.empty());
}

TEST(FractionalRacks, ARibKnittedAtAQuarterCrossesNothing) {
    std::string lines = "rack 0.25\nin 1\n";
    for (int course = 0; course < 4; ++course) {
        for (int i = 0; i < 6; ++i) {
            const int needle = course % 2 == 0 ? i : 5 - i;
            const std::string direction = course % 2 == 0 ? "+" : "-";
            // In the order in which the needles lie: f0 b0 f1 b1 ...
            for (const char bed : {course % 2 == 0 ? 'f' : 'b', course % 2 == 0 ? 'b' : 'f'}) {
                lines += "knit " + direction + ' ' + bed + std::to_string(needle) + " 1\n";
            }
        }
    }
    const Fabric fabric = build(lines);
    EXPECT_EQ(fabric.loops.size(), 48U);
    EXPECT_TRUE(fabric.crossings.empty());
}

TEST(FractionalRacks, TransfersNeedAWholeRack) {
    const std::string held = "in 1\nknit + f3 1\n";
    for (const char* rack : {"0.25", "0.5", "-0.75", "1.25"}) {
        EXPECT_FALSE(test::isValid(test::program(held + "rack " + rack + "\nxfer f3 b3\n"))) << rack;
    }
    EXPECT_TRUE(test::isValid(test::program(held + "rack 0.25\nrack 0\nxfer f3 b3\n")));
    EXPECT_TRUE(test::isValid(test::program(held + "rack -2\nxfer f3 b5\n")));
    EXPECT_FALSE(test::isValid(test::program(held + "rack -2\nxfer f3 b3\n")));
    EXPECT_FALSE(test::isValid(test::program(held + "rack 0.5\nsplit + f3 b3 1\n")));
}

} // namespace
} // namespace knittsim::fabric
