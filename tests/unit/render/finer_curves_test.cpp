#include "ui/render/finer_curves.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace knittsim::render {
namespace {

/// Two yarns on a circle of radius 1, with corners as a stitch has them.
geometry::YarnCurves arcs() {
    geometry::YarnCurves curves;
    for (int yarn = 0; yarn < 2; ++yarn) {
        curves.yarns.push_back(
            {static_cast<std::int32_t>(curves.nodes.size()), 9, static_cast<machine::CarrierIndex>(yarn)});
        for (int i = 0; i < 9; ++i) {
            const float angle = static_cast<float>(i) * std::numbers::pi_v<float> / 8;
            curves.nodes.emplace_back(std::cos(angle), std::sin(angle), static_cast<float>(yarn));
            curves.point.push_back(10 * yarn + i);
            curves.piece.push_back(10 * yarn + i);
            curves.arc.push_back(angle);
            curves.normal.emplace_back(0.0F, 0.0F, 1.0F);
            curves.height.push_back(0.1F * static_cast<float>(i));
        }
    }
    return curves;
}

TEST(FinerCurves, goThroughAllNodesAndStayOnTheCircle) {
    const geometry::YarnCurves coarse = arcs();
    const geometry::YarnCurves fine = finer(coarse, 4);
    ASSERT_EQ(fine.yarns.size(), 2U);
    for (std::size_t y = 0; y < 2; ++y) {
        EXPECT_EQ(fine.yarns[y].count, 8 * 4 + 1);
        EXPECT_EQ(fine.yarns[y].carrier, coarse.yarns[y].carrier);
        for (int i = 0; i < 9; ++i) {
            const auto from = static_cast<std::size_t>(coarse.yarns[y].first + i);
            const auto to = static_cast<std::size_t>(fine.yarns[y].first + 4 * i);
            EXPECT_EQ(fine.nodes[to], coarse.nodes[from]);
            EXPECT_EQ(fine.point[to], coarse.point[from]);
        }
    }
    for (std::size_t n = 8; n < 25; ++n) {                     // away from the ends, which have one neighbour
        EXPECT_NEAR(fine.nodes[n].head<2>().norm(), 1, 0.002); // a chord would be 0.02 off
        EXPECT_GT(fine.arc[n + 1], fine.arc[n]);
    }
}

TEST(FinerCurves, valuesGoOverInStraightLines) {
    const geometry::YarnCurves coarse = arcs();
    const std::vector<float> fine = finer(coarse, coarse.height, 2);
    ASSERT_EQ(fine.size(), 34U);
    EXPECT_FLOAT_EQ(fine[2], 0.1F);
    EXPECT_FLOAT_EQ(fine[3], 0.15F);
    EXPECT_FLOAT_EQ(fine[16], 0.8F);
    EXPECT_FLOAT_EQ(fine[17], 0); // the next yarn
    EXPECT_EQ(finer(coarse, 2).nodes.size(), fine.size());
}

} // namespace
} // namespace knittsim::render
