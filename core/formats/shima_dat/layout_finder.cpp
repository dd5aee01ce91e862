#include "core/formats/shima_dat/layout_finder.h"

#include <algorithm>

namespace knittsim::formats::shima_dat {

namespace {

using Row = std::span<const std::uint8_t>;

constexpr int kReach = 2 * (kOptionLines - 1); ///< from the mark of line 1 to that of the last

std::uint8_t at(Row row, int column) {
    return row[static_cast<std::size_t>(column)];
}

bool isDirection(std::uint8_t mark) {
    return mark == 1 || mark == kGoesLeft || mark == kGoesRight;
}

/// The marks 2, 3, ... stand at every second column from line 1 on, `step` +2 or -2.
bool hasMarks(Row row, int lineOne, int step) {
    const int last = lineOne + (step > 0 ? kReach : -kReach);
    // Behind each mark stands a value, also behind the outermost.
    if (std::min(lineOne, last) < 1 || std::max(lineOne, last) + 1 >= static_cast<int>(row.size()) ||
        !isDirection(at(row, lineOne))) {
        return false;
    }
    for (int line = 2; line <= kOptionLines; ++line) {
        if (at(row, lineOne + step * (line - 1)) != line) {
            return false;
        }
    }
    return true;
}

bool isPass(Row row, const Frame& frame) {
    return hasMarks(row, frame.leftMark, -2) && hasMarks(row, frame.rightMark, 2) &&
           at(row, frame.leftMark) == at(row, frame.rightMark);
}

/// The frame of a row that has option lines on both sides and a slot between them.
std::optional<Frame> frameOf(Row row) {
    const int width = static_cast<int>(row.size());
    const auto first = std::find(row.begin(), row.end(), std::uint8_t{kOptionLines});
    const int outermost = static_cast<int>(first - row.begin());
    Frame frame;
    frame.leftMark = outermost + kReach;
    if (frame.leftMark + kReach + 2 * kGap >= width || !hasMarks(row, frame.leftMark, -2)) {
        return std::nullopt;
    }
    for (int column = frame.leftMark + 2 * kGap + 2; column + kReach + 1 < width; ++column) {
        if (hasMarks(row, column, 2)) {
            frame.rightMark = column;
            return frame;
        }
    }
    return std::nullopt;
}

/// The needle number beside the line that marks the width of the piece; 1 where there is none.
int positionIn(const Raster& raster, const Frame& frame) {
    for (int y = frame.endRow; y + 1 < raster.height; ++y) {
        const Row row = raster.row(y);
        const auto begin = row.begin() + frame.firstColumn() - kGap;
        const auto end = row.begin() + frame.endColumn() + kGap;
        if (std::all_of(begin, end, [](std::uint8_t colour) { return colour == 1; })) {
            const int column = frame.leftMark - 1;
            const int position = at(row, column) + 100 * at(raster.row(y + 1), column);
            return std::max(position, 1);
        }
    }
    return 1;
}

} // namespace

std::optional<Frame> findFrame(const Raster& raster) {
    std::optional<Frame> frame;
    int y = 0;
    for (; y < raster.height && !frame; ++y) {
        frame = frameOf(raster.row(y));
    }
    if (!frame) {
        return std::nullopt;
    }
    frame->firstRow = y - 1;
    while (y < raster.height && isPass(raster.row(y), *frame)) {
        ++y;
    }
    frame->endRow = y;
    for (; y < raster.height; ++y) {
        if (isPass(raster.row(y), *frame)) {
            return std::nullopt;
        }
    }
    frame->firstNeedle = positionIn(raster, *frame);
    return frame;
}

Options optionsOf(const Raster& raster, const Frame& frame, int row) {
    const Row pixels = raster.row(row);
    Options options;
    for (int line = 1; line <= kOptionLines; ++line) {
        const auto index = static_cast<std::size_t>(line);
        options.left[index] = at(pixels, frame.leftMark - 2 * (line - 1) - 1);
        options.right[index] = at(pixels, frame.rightMark + 2 * (line - 1) + 1);
    }
    const std::uint8_t mark = at(pixels, frame.leftMark);
    if (mark != 1) {
        options.direction = mark == kGoesRight ? machine::Direction::Right : machine::Direction::Left;
    }
    return options;
}

} // namespace knittsim::formats::shima_dat
