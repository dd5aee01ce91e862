#include "ui/render/level_of_detail.h"

#include <gtest/gtest.h>

namespace knittsim::render {
namespace {

TEST(LevelOfDetail, growsWithTheSizeOnTheScreen) {
    for (const Quality quality : {Quality::Fast, Quality::Best}) {
        Detail before = detailAt(0.5F, 0.1F, quality);
        for (float pixels = 1; pixels < 200; pixels += 0.5F) {
            const Detail detail = detailAt(pixels, 0.1F, quality);
            EXPECT_GE(detail.sides, before.sides);
            EXPECT_LE(detail.stride, before.stride);
            EXPECT_GE(detail.plies, before.plies);
            before = detail;
        }
        EXPECT_EQ(before.stride, 2); // pieces of a quarter of the diameter at most
        EXPECT_EQ(before.plies, 1);
    }
}

TEST(LevelOfDetail, bestIsNeverCoarserThanFast) {
    for (float pixels = 1; pixels < 100; pixels += 0.5F) {
        const Detail fast = detailAt(pixels, 0.06F, Quality::Fast);
        const Detail best = detailAt(pixels, 0.06F, Quality::Best);
        EXPECT_GE(best.sides, fast.sides);
        EXPECT_LE(best.stride, fast.stride);
        EXPECT_GE(best.plies, fast.plies);
    }
}

TEST(LevelOfDetail, strideStaysWhatNodesAreAlignedTo) {
    EXPECT_EQ(detailAt(1, 1e-6F, Quality::Fast).stride, kMostStride);
    EXPECT_EQ(detailAt(1, 10, Quality::Fast).stride, 1);
}

TEST(LevelOfDetail, whatIsFixedHoldsAtAnyDistance) {
    for (const DetailLevel level : {DetailLevel::Strokes, DetailLevel::Tubes, DetailLevel::Yarn}) {
        for (float pixels = 1; pixels < 100; pixels += 0.5F) {
            const Detail detail = detailAt(pixels, 0.06F, Quality::Fast, level);
            EXPECT_EQ(levelOf(detail), level) << pixels;
            EXPECT_EQ(detail.stride, detailAt(pixels, 0.06F, Quality::Fast).stride);
        }
    }
    // Nothing is lost where one is fixed that would have been drawn anyway.
    EXPECT_EQ(detailAt(60, 0.06F, Quality::Best, DetailLevel::Yarn).sides,
              detailAt(60, 0.06F, Quality::Best).sides);
}

TEST(Frustum, seesWhatTheCameraShows) {
    for (const bool orthographic : {true, false}) {
        Camera camera;
        camera.setViewport(400, 200);
        camera.setState({.target = {10, 0, 0}, .yaw = 0.5F, .halfHeight = 5, .orthographic = orthographic});
        const Frustum frustum(camera);
        const Vec3f middle = camera.state().target;
        EXPECT_TRUE(frustum.sees(middle, 0.1F));
        EXPECT_TRUE(frustum.sees(middle + 9.8F * camera.right(), 0.1F));
        EXPECT_FALSE(frustum.sees(middle + 11 * camera.right(), 0.5F));
        EXPECT_TRUE(frustum.sees(middle + 11 * camera.right(), 1.5F));
        EXPECT_FALSE(frustum.sees(middle + 6 * camera.up(), 0.5F));
        EXPECT_FALSE(frustum.sees(middle - 6 * camera.up(), 0.5F));
    }
}

} // namespace
} // namespace knittsim::render
