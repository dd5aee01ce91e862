#pragma once

#include "ui/render/image.h"

#include <string>

namespace knittsim::test {

/// Blocks of 3 x 3 pixels in which all nine deviate to the same side, in one colour channel, by this or more.
constexpr int kBlockTolerance = 8;

struct BlockDifference {
    int blocks = 0; ///< that differ
    int x = -1;     ///< pixel of the first one
    int y = -1;
    std::string text() const;
};

/// Both images must be of the same size. A margin of less than a block at the right and the bottom is not
/// compared.
BlockDifference compareBlocks(const render::Image& a, const render::Image& b);

} // namespace knittsim::test
