#include "tests/support/build.h"
#include "tests/support/lattice.h"
#include "ui/render/movement.h"

#include <gtest/gtest.h>

namespace knittsim::render {
namespace {

TEST(Movement, IsTheWayOfEachBondingPoint) {
    const auto fabric = test::build("in 1\n" + test::pass("knit", 'f', 3, 0, 1) +
                                    test::pass("knit", 'f', 0, 3, 1) + "out 1\n");
    const std::vector<float> before = test::relaxedLattice(fabric, 5);
    std::vector<float> now = before;
    now[0] += 3; // entry 0, by 3 and 4: 5 mm
    now[1] -= 4;
    const auto moved = movementOfPoints(fabric, now, before);
    ASSERT_EQ(moved.size(), fabric.points.size());
    int far = 0;
    for (std::size_t p = 0; p < moved.size(); ++p) {
        EXPECT_FLOAT_EQ(moved[p], fabric.points[p].entry == 0 ? 5 : 0);
        far += moved[p] > 0 ? 1 : 0;
    }
    EXPECT_GT(far, 0);
}

TEST(Movement, ShapesOfAnotherFabricTellNothing) {
    const auto fabric = test::build("in 1\n" + test::pass("knit", 'f', 3, 0, 1) + "out 1\n");
    const std::vector<float> now = test::relaxedLattice(fabric, 5);
    EXPECT_TRUE(movementOfPoints(fabric, now, {}).empty());
    EXPECT_TRUE(movementOfPoints(fabric, std::vector<float>(now.size() + 3), now).empty());
}

TEST(Movement, OfCurvesIsByNode) {
    geometry::YarnCurves before;
    before.nodes = {{0, 0, 0}, {1, 0, 0}};
    geometry::YarnCurves now = before;
    now.nodes[1] = {1, 0, 2};
    EXPECT_EQ(movementOfNodes(now, before), (std::vector<float>{0, 2}));
    now.nodes.emplace_back(2, 0, 0);
    EXPECT_TRUE(movementOfNodes(now, before).empty());
}

} // namespace
} // namespace knittsim::render
