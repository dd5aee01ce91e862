#include "core/formats/shima_dat/raster.h"

#include "core/formats/shima_dat/layout.h"
#include "core/formats/shima_dat/palette.h"

#include <algorithm>

namespace knittsim::formats::shima_dat {

namespace {

constexpr std::size_t kMaxRun = 255;

std::uint8_t byteAt(std::string_view bytes, std::size_t at) {
    return static_cast<std::uint8_t>(bytes[at]);
}

int numberAt(std::string_view bytes, std::size_t at) {
    return byteAt(bytes, at) | byteAt(bytes, at + 1) << 8;
}

void putNumber(std::string& bytes, std::size_t at, int number) {
    bytes[at] = static_cast<char>(number & 0xFF);
    bytes[at + 1] = static_cast<char>(number >> 8);
}

/// Fills the picture from its runs. A run belongs to one row.
bool fill(Raster& raster, std::string_view runs, Problems& problems) {
    const auto width = static_cast<std::size_t>(raster.width);
    std::size_t at = 0;
    for (std::size_t i = 0; i + 1 < runs.size(); i += 2) {
        const std::size_t count = byteAt(runs, i + 1);
        const int row = static_cast<int>(at / width) + 1;
        if (at + count > raster.pixels.size()) {
            problems.error("KS0131", {row, 1},
                           {std::to_string(raster.width), std::to_string(raster.height), "more"});
            return false;
        }
        if (at % width + count > width) {
            problems.error("KS0132", {row, static_cast<int>(at % width) + 1},
                           {std::to_string(count), std::to_string(width)});
            return false;
        }
        std::fill_n(raster.pixels.begin() + static_cast<std::ptrdiff_t>(at), count, byteAt(runs, i));
        at += count;
    }
    if (at != raster.pixels.size()) {
        problems.error("KS0131", {static_cast<int>(at / width) + 1, 1},
                       {std::to_string(raster.width), std::to_string(raster.height), std::to_string(at)});
        return false;
    }
    return true;
}

} // namespace

bool hasSignature(std::string_view bytes) {
    return bytes.size() >= kDataOffset && numberAt(bytes, 8) == kMagicNumber &&
           numberAt(bytes, 16) == kMagicNumber;
}

Raster decode(std::string_view bytes, Problems& problems) {
    if (!hasSignature(bytes)) {
        problems.error("KS0130", {1, 1}, {"the numbers at bytes 8 and 16 of the header are not 1000"});
        return {};
    }
    const std::int64_t width = std::int64_t{numberAt(bytes, 4)} - numberAt(bytes, 0) + 1;
    const std::int64_t height = std::int64_t{numberAt(bytes, 6)} - numberAt(bytes, 2) + 1;
    const std::string_view runs = bytes.substr(kDataOffset);
    if (width < 1 || height < 1) {
        problems.error("KS0130", {1, 1}, {"its corners are the wrong way round"});
        return {};
    }
    const auto claimed = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    const std::size_t most = std::min(runs.size() / 2 * kMaxRun, kMaxPixels);
    if (claimed > most) {
        problems.error("KS0131", {1, 1},
                       {std::to_string(width), std::to_string(height), "at most " + std::to_string(most)});
        return {};
    }
    Raster raster(static_cast<int>(width), static_cast<int>(height));
    return fill(raster, runs, problems) ? std::move(raster) : Raster();
}

std::string encode(const Raster& raster) {
    std::string bytes(kDataOffset, '\0');
    putNumber(bytes, 4, raster.width - 1);
    putNumber(bytes, 6, raster.height - 1);
    putNumber(bytes, 8, kMagicNumber);
    putNumber(bytes, 16, kMagicNumber);
    std::copy(kPalette.begin(), kPalette.end(), bytes.begin() + kHeaderBytes);
    for (int y = 0; y < raster.height; ++y) {
        const auto row = raster.row(y);
        for (auto at = row.begin(); at != row.end();) {
            const auto room = std::min<std::ptrdiff_t>(row.end() - at, kMaxRun);
            const auto end = std::find_if(at, at + room, [&](std::uint8_t colour) { return colour != *at; });
            bytes += static_cast<char>(*at);
            bytes += static_cast<char>(end - at);
            at = end;
        }
    }
    return bytes;
}

} // namespace knittsim::formats::shima_dat
