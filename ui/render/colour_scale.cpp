#include "ui/render/colour_scale.h"

#include "core/base/round_numbers.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace knittsim::render {

namespace {

constexpr double kSticksOut = 0.02; ///< share of the values at each end
constexpr float kSteps = 4;         ///< of a scale, about
constexpr float kNoneBelow = 0.1F;  ///< of the highest

std::uint8_t between(std::uint8_t a, std::uint8_t b, float share) {
    return static_cast<std::uint8_t>(
        std::lround((1 - share) * static_cast<float>(a) + share * static_cast<float>(b)));
}

} // namespace

float ValueRange::shareOf(float value) const {
    return empty() ? 0 : std::clamp((value - low) / (high - low), 0.0F, 1.0F);
}

ValueRange rangeOf(std::span<const float> values) {
    std::vector<float> finite;
    finite.reserve(values.size());
    std::ranges::copy_if(values, std::back_inserter(finite), [](float v) { return std::isfinite(v); });
    if (finite.empty()) {
        return {};
    }
    const auto out = static_cast<std::ptrdiff_t>(kSticksOut * static_cast<double>(finite.size()));
    const auto last = static_cast<std::ptrdiff_t>(finite.size()) - 1 - out;
    std::ranges::nth_element(finite, finite.begin() + last);
    const float high = finite[static_cast<std::size_t>(last)];
    std::ranges::nth_element(finite, finite.begin() + out);
    const float low = finite[static_cast<std::size_t>(out)];
    const float top = std::max(0.0F, high);
    const float bottom = low < -kNoneBelow * top ? low : 0.0F;
    if (!(top > bottom)) {
        return {};
    }
    const auto step = static_cast<float>(roundUp((top - bottom) / kSteps));
    return {step * std::floor(bottom / step), step * std::ceil(top / step), step};
}

const std::array<yarn::Colour, kRampColours>& ramp() {
    static constexpr std::array<yarn::Colour, kRampColours> kRamp{{{67, 35, 131},
                                                                   {53, 78, 163},
                                                                   {21, 121, 171},
                                                                   {40, 157, 169},
                                                                   {76, 193, 149},
                                                                   {162, 219, 96},
                                                                   {252, 232, 65}}};
    return kRamp;
}

yarn::Colour rampColour(float share) {
    const float place = std::clamp(share, 0.0F, 1.0F) * static_cast<float>(kRampColours - 1);
    const auto i = std::min(static_cast<std::size_t>(place), kRampColours - 2);
    const yarn::Colour& a = ramp()[i];
    const yarn::Colour& b = ramp()[i + 1];
    const float t = place - static_cast<float>(i);
    return {between(a.r, b.r, t), between(a.g, b.g, t), between(a.b, b.b, t)};
}

} // namespace knittsim::render
