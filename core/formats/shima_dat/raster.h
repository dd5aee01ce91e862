#pragma once

#include "core/formats/problems.h"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace knittsim::formats::shima_dat {

/// Largest picture that is read: 65,000 passes of 1,000 columns. Bounds the memory.
constexpr std::size_t kMaxPixels = std::size_t{64} << 20;

/// A picture of colour numbers, the lowest row first.
struct Raster {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> pixels;

    Raster() = default;
    Raster(int w, int h)
        : width(w), height(h), pixels(static_cast<std::size_t>(w) * static_cast<std::size_t>(h)) {}

    std::span<std::uint8_t> row(int y) {
        return std::span(pixels).subspan(static_cast<std::size_t>(y) * static_cast<std::size_t>(width),
                                         static_cast<std::size_t>(width));
    }
    std::span<const std::uint8_t> row(int y) const {
        return std::span(pixels).subspan(static_cast<std::size_t>(y) * static_cast<std::size_t>(width),
                                         static_cast<std::size_t>(width));
    }
};

/// The two fixed numbers of the header are there.
bool hasSignature(std::string_view bytes);

/// Header, palette and runs. Sizes are checked against the bytes there are before memory is taken.
/// Errors: KS0130, KS0131, KS0132; then the picture is empty.
Raster decode(std::string_view bytes, Problems& problems);

/// The other way round, with the usual palette.
std::string encode(const Raster& raster);

} // namespace knittsim::formats::shima_dat
