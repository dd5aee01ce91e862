#include "tests/golden/blocks.h"

#include <gtest/gtest.h>

namespace knittsim::test {
namespace {

render::Image grey(int value) {
    return {9, 6, std::vector<std::uint8_t>(9 * 6 * 4, static_cast<std::uint8_t>(value))};
}

void brighten(render::Image& image, int x, int y, int by) {
    auto& pixel = image.pixels[static_cast<std::size_t>(4 * (9 * y + x))];
    pixel = static_cast<std::uint8_t>(pixel + by);
}

TEST(Blocks, oneDeviatingPixelOrEdgeDoesNotCount) {
    render::Image other = grey(100);
    for (int y = 0; y < 6; ++y) {
        brighten(other, 4, y, 90);
    }
    EXPECT_EQ(compareBlocks(grey(100), other).blocks, 0);
}

TEST(Blocks, aBlockThatDeviatesAsAWholeCounts) {
    render::Image other = grey(100);
    for (int i = 0; i < 9; ++i) {
        brighten(other, 3 + i % 3, 3 + i / 3, kBlockTolerance);
    }
    const BlockDifference difference = compareBlocks(grey(100), other);
    EXPECT_EQ(difference.blocks, 1);
    EXPECT_EQ(difference.x, 3);
    EXPECT_EQ(difference.y, 3);
    EXPECT_EQ(compareBlocks(other, grey(100)).blocks, 1);
    brighten(other, 5, 5, -1);
    EXPECT_EQ(compareBlocks(grey(100), other).blocks, 0);
}

TEST(Blocks, deviationToBothSidesIsNoise) {
    render::Image other = grey(100);
    for (int i = 0; i < 9; ++i) {
        brighten(other, i % 3, i / 3, i % 2 == 0 ? 60 : -60);
    }
    EXPECT_EQ(compareBlocks(grey(100), other).blocks, 0);
}

} // namespace
} // namespace knittsim::test
