#pragma once

#include "core/formats/passes/pass.h"

#include <array>
#include <cstdint>
#include <optional>

/// The picture as programs of the open knitout tools lay it out. One row is one carriage pass, the lowest
/// first; a column is a slot (passes::Pass); to the left and right of the columns stand option lines, pairs
/// of a mark and a value.
namespace knittsim::formats::shima_dat {

constexpr std::size_t kHeaderBytes = 0x200;
constexpr std::size_t kDataOffset = 0x600; ///< of the runs; the palette lies before them
constexpr int kMagicNumber = 1000;         ///< at bytes 8 and 16
constexpr int kMaxSide = 0xFFFE;           ///< pixels

constexpr int kOptionLines = 20;
constexpr int kGap = 5;    ///< columns between option lines and the first or last slot
constexpr int kOuter = 10; ///< empty columns outside the option lines
constexpr int kMargin = kOuter + 2 * kOptionLines + kGap;
constexpr int kRowsBelow = 5;
constexpr int kRowsAbove = 8;
constexpr int kFrameRows = 3; ///< fixed passes before and after the program

constexpr std::uint8_t kStopMark = 13;
constexpr std::uint8_t kSoftMiss = 16;
constexpr std::uint8_t kGoesRight = 6; ///< mark of option line 1
constexpr std::uint8_t kGoesLeft = 7;
constexpr std::uint8_t kNoCarrier = 255; ///< value of R3
constexpr int kCarriers = 10;

namespace left {
constexpr int kRacking = 2;
constexpr int kInterleaved = 3;
constexpr int kRackingSide = 4; ///< 10 left, 11 right and one more
constexpr int kKnitSpeed = 5;
constexpr int kTransferSpeed = 6;
constexpr int kPause = 7;
constexpr int kSplitOrMiss = 12; ///< 10 split, 20 a-miss
constexpr int kSliders = 13;     ///< 1 to, 3 from the sliders
} // namespace left

namespace right {
constexpr int kCarrier = 3;
constexpr int kCancel = 5; ///< 1 no knitting, 2 the carriage moves first
constexpr int kStitch = 6;
constexpr int kDropSinker = 7;
constexpr int kNoLinks = 9;
constexpr int kGripper = 10; ///< carrier comes in; 100 more: goes out
constexpr int kPresser = 11;
constexpr int kTransferStitch = 13;
constexpr int kHook = 15; ///< 10 in, 20 out, 90 release
} // namespace right

/// Colour of what the two needles of a slot do.
struct Colour {
    std::uint8_t number;
    passes::Cell cell;
};

// A cell that stands twice is written with the first colour; all are read.
constexpr auto kColours = [] {
    using enum passes::Work;
    return std::to_array<Colour>({
        {51, {Knit, None}},
        {52, {None, Knit}},
        {11, {Tuck, None}},
        {12, {None, Tuck}},
        {216, {Miss, None}},
        {217, {None, Miss}},
        {16, {None, None}},
        {3, {Knit, Knit}},
        {41, {Knit, Tuck}},
        {42, {Tuck, Knit}},
        {88, {Tuck, Tuck}},
        {20, {Transfer, None}},
        {30, {None, Transfer}},
        {101, {Split, None}},
        {102, {None, Split}},
        {116, {Miss, None}},
        {117, {None, Miss}},
    });
}();

/// The colour with this number, or nullptr.
constexpr const Colour* findColour(std::uint8_t number) {
    constexpr auto kByNumber = [] {
        std::array<std::int8_t, 256> table{};
        table.fill(-1);
        for (std::size_t i = 0; i < kColours.size(); ++i) {
            table[kColours[i].number] = static_cast<std::int8_t>(i);
        }
        return table;
    }();
    const std::int8_t index = kByNumber[number];
    return index < 0 ? nullptr : &kColours[static_cast<std::size_t>(index)];
}

/// Split to a slider that gives the loop back `way` slots to the right on the bed it came from.
struct SliderSplit {
    std::uint8_t number;
    bool front;
    int way;
};

constexpr auto kSliderSplits = std::to_array<SliderSplit>({
    {106, true, -1},
    {107, true, 1},
    {108, false, -1},
    {109, false, 1},
    {126, true, -2},
    {127, true, 2},
    {128, false, -2},
    {129, false, 2},
    {146, true, -4},
    {147, true, 4},
    {148, false, -4},
    {149, false, 4},
});

/// Option values of one row by number 1 to kOptionLines; 0 where the line is empty.
struct Options {
    std::array<std::uint8_t, kOptionLines + 1> left{};
    std::array<std::uint8_t, kOptionLines + 1> right{};
    std::optional<machine::Direction> direction;

    bool operator==(const Options&) const = default;
};

} // namespace knittsim::formats::shima_dat
