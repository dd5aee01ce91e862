#include "tests/golden/blocks.h"

#include <algorithm>
#include <limits>

namespace knittsim::test {

namespace {

bool differs(const render::Image& a, const render::Image& b, int x, int y) {
    for (int channel = 0; channel < 4; ++channel) {
        int least = std::numeric_limits<int>::max();
        int most = std::numeric_limits<int>::min();
        for (int i = 0; i < 9; ++i) {
            const int px = x + i % 3;
            const int py = y + i / 3;
            const int difference = int{a.at(px, py)[channel]} - int{b.at(px, py)[channel]};
            least = std::min(least, difference);
            most = std::max(most, difference);
        }
        if (least >= kBlockTolerance || most <= -kBlockTolerance) {
            return true;
        }
    }
    return false;
}

} // namespace

std::string BlockDifference::text() const {
    return std::to_string(blocks) + " blocks differ, the first one at " + std::to_string(x) + ", " +
           std::to_string(y);
}

BlockDifference compareBlocks(const render::Image& a, const render::Image& b) {
    BlockDifference result;
    for (int y = 0; y + 3 <= a.height; y += 3) {
        for (int x = 0; x + 3 <= a.width; x += 3) {
            if (differs(a, b, x, y)) {
                if (result.blocks == 0) {
                    result.x = x;
                    result.y = y;
                }
                ++result.blocks;
            }
        }
    }
    return result;
}

} // namespace knittsim::test
