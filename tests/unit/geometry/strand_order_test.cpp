#include "core/geometry/strand_order.h"
#include "tests/unit/geometry/plain_case.h"

#include <gtest/gtest.h>

namespace knittsim::geometry {
namespace {

using fabric::Role;
using test::kDiameterMm;

std::vector<StrandDepth> depthsOf(const fabric::Fabric& fabric) {
    const std::vector<double> diameters(4, kDiameterMm);
    return orderStrands(fabric, diameters);
}

/// Checks every entry where one foot meets one head.
void expectDrawnThrough(const fabric::Fabric& fabric, float sign) {
    const auto depths = depthsOf(fabric);
    int seen = 0;
    for (fabric::EntryIndex entry = 0; entry < fabric.entryCount; ++entry) {
        const auto points = fabric.at(entry);
        if (points.size() != 2) {
            continue;
        }
        const bool firstIsFoot = fabric.points[static_cast<std::size_t>(points[0])].role == Role::Foot;
        const auto& foot = depths[static_cast<std::size_t>(points[firstIsFoot ? 0 : 1])];
        const auto& head = depths[static_cast<std::size_t>(points[firstIsFoot ? 1 : 0])];
        EXPECT_NEAR(sign * (head.lower - foot.lower), kDiameterMm, 1e-6) << "entry " << entry;
        EXPECT_NEAR(sign * (foot.upper - head.upper), kDiameterMm, 1e-6) << "entry " << entry;
        ++seen;
    }
    EXPECT_EQ(seen, 2 * 4 * 2); // four wales, two courses drawn through one below
}

TEST(StrandOrder, frontBedLoopComesFromBehindThenInFront) {
    expectDrawnThrough(test::knit("ffff", 3), +1);
}

TEST(StrandOrder, rearBedLoopIsItsMirrorImage) {
    expectDrawnThrough(test::knit("bbbb", 3), -1);
}

TEST(StrandOrder, stackedLoopsLieInTheOrderOfTheNeedle) {
    // Loop of f1 moves over b1 onto f2 and lies there on top of the loop of f2: second in the stack.
    const auto fabric =
        test::build("in 1\n" + test::pass("knit", 'f', 4, 1, 1) + "xfer f1 b1\nrack 1\nxfer b1 f2\nrack 0\n" +
                    test::pass("knit", 'f', 2, 4, 1) + "out 1\n");
    const auto& child = fabric.loops[4];
    const auto parents = fabric.made.parentsOf(4);
    ASSERT_EQ(parents.size(), 2U);
    const auto depths = depthsOf(fabric);
    const auto& first =
        depths[static_cast<std::size_t>(fabric.loops[static_cast<std::size_t>(parents[0])].headLeft)];
    const auto& second =
        depths[static_cast<std::size_t>(fabric.loops[static_cast<std::size_t>(parents[1])].headLeft)];
    const auto& foot = depths[static_cast<std::size_t>(child.footLeft)];
    EXPECT_GT(first.lower, second.lower);
    EXPECT_GT(first.upper, second.upper);
    EXPECT_LT(foot.lower, second.lower);
    EXPECT_GT(foot.upper, first.upper);
}

TEST(StrandOrder, crossingSetsTheOverStrandInFront) {
    // The float of carrier 2 passes the loop held on f2 between the beds: behind it.
    const auto fabric = test::build("in 1\nin 2\n" + test::pass("knit", 'f', 3, 1, 1) +
                                    "knit - f5 2\nmiss - f3 2\nknit - f0 2\nout 1\nout 2\n");
    ASSERT_FALSE(fabric.crossings.empty());
    const auto depths = depthsOf(fabric);
    for (const fabric::Crossing& crossing : fabric.crossings) {
        EXPECT_GT(depths[static_cast<std::size_t>(crossing.over)].lower,
                  depths[static_cast<std::size_t>(crossing.under)].lower);
    }
}

} // namespace
} // namespace knittsim::geometry
