#include "ui/render/fibre_noise.h"

#include <algorithm>
#include <random>

namespace knittsim::render {

namespace {

std::size_t texel(int x, int y) {
    constexpr int kMask = kNoiseSize - 1;
    return static_cast<std::size_t>((y & kMask) * kNoiseSize + (x & kMask));
}

/// White noise averaged over a box, stretched to the whole range.
std::vector<float> blurredNoise(std::uint32_t seed, int halfWidth, int halfHeight) {
    std::mt19937 random(seed);
    std::vector<float> white(static_cast<std::size_t>(kNoiseSize) * kNoiseSize);
    for (float& value : white) {
        value = static_cast<float>(random() & 0xffffU) / 65535.0F;
    }
    std::vector<float> smooth(white.size(), 0);
    for (int y = 0; y < kNoiseSize; ++y) {
        for (int x = 0; x < kNoiseSize; ++x) {
            for (int dy = -halfHeight; dy <= halfHeight; ++dy) {
                for (int dx = -halfWidth; dx <= halfWidth; ++dx) {
                    smooth[texel(x, y)] += white[texel(x + dx, y + dy)];
                }
            }
        }
    }
    const auto [low, high] = std::ranges::minmax_element(smooth);
    const float from = *low;
    const float range = std::max(1e-6F, *high - from);
    for (float& value : smooth) {
        value = (value - from) / range;
    }
    return smooth;
}

} // namespace

std::vector<std::uint8_t> makeFibreNoise() {
    const std::vector<float> fine = blurredNoise(1, 9, 0);
    const std::vector<float> coarse = blurredNoise(3, 22, 2);
    const std::vector<float> spots = blurredNoise(2, 3, 3);
    std::vector<std::uint8_t> texels;
    texels.reserve(fine.size() * 2);
    for (std::size_t i = 0; i < fine.size(); ++i) {
        texels.push_back(static_cast<std::uint8_t>(255 * (0.6F * fine[i] + 0.4F * coarse[i])));
        texels.push_back(static_cast<std::uint8_t>(255 * spots[i]));
    }
    return texels;
}

} // namespace knittsim::render
