#include "core/formats/shima_dat/raster.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <random>

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t maxSize);

namespace {

using knittsim::formats::shima_dat::Raster;

/// Changes pixels and swaps rows of a picture, so that most inputs stay pictures.
void change(Raster& raster, std::minstd_rand& random) {
    constexpr std::array<std::uint8_t, 24> kColours{0,  13,  16,  51,  52,  11,  12,  3, 41, 42,  88, 20,
                                                    30, 101, 102, 216, 217, 107, 129, 1, 10, 255, 90, 100};
    const auto below = [&](std::size_t count) { return static_cast<std::size_t>(random() % count); };
    const auto height = static_cast<std::size_t>(raster.height);
    if (below(4) == 0) {
        const auto a = raster.row(static_cast<int>(below(height)));
        const auto b = raster.row(static_cast<int>(below(height)));
        std::swap_ranges(a.begin(), a.end(), b.begin());
        return;
    }
    raster.pixels[below(raster.pixels.size())] =
        below(3) == 0 ? static_cast<std::uint8_t>(below(256)) : kColours[below(kColours.size())];
}

} // namespace

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t maxSize,
                                               unsigned seed) {
    using namespace knittsim::formats;
    std::minstd_rand random(seed);
    Problems problems("", 1);
    Raster raster = shima_dat::decode({reinterpret_cast<const char*>(data), size}, problems);
    if (seed % 8 == 0 || raster.pixels.empty()) {
        return LLVMFuzzerMutate(data, size, maxSize);
    }
    for (unsigned i = 1 + seed / 8 % 6; i > 0; --i) {
        change(raster, random);
    }
    const std::string bytes = shima_dat::encode(raster);
    const std::size_t count = std::min(bytes.size(), maxSize);
    std::memcpy(data, bytes.data(), count);
    return count;
}
