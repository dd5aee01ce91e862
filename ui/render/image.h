#pragma once

#include "core/base/file.h"
#include "core/base/progress.h"

#include <cstdint>
#include <filesystem>
#include <vector>

namespace knittsim::render {

/// 8-bit RGBA, not premultiplied, rows from top to bottom without padding.
struct Image {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> pixels; ///< 4 * width * height

    const std::uint8_t* at(int x, int y) const {
        return pixels.data() + 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                                    static_cast<std::size_t>(x));
    }
};

/// Errors: KS0002, KS0009 (cancelled), KS0404.
Result<Written> writePng(const std::filesystem::path& path, const Image& image,
                         const Progress& progress = {});

/// Reads any PNG as 8-bit RGBA. Errors: KS0001, KS0405.
Result<Image> readPng(const std::filesystem::path& path);

} // namespace knittsim::render
