#include "core/pattern/ok_lab.h"

#include <algorithm>
#include <cmath>

namespace knittsim::pattern {

double linearOf(std::uint8_t channel) {
    const double value = channel / 255.0;
    return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

std::uint8_t channelOf(double linear) {
    const double light = std::clamp(linear, 0.0, 1.0);
    const double value = light <= 0.0031308 ? light * 12.92 : 1.055 * std::pow(light, 1 / 2.4) - 0.055;
    return static_cast<std::uint8_t>(std::lround(value * 255));
}

LinearRgb linearOf(yarn::Colour colour) {
    return {linearOf(colour.r), linearOf(colour.g), linearOf(colour.b)};
}

yarn::Colour colourOf(const LinearRgb& light) {
    return {channelOf(light[0]), channelOf(light[1]), channelOf(light[2])};
}

OkLab okLabOf(const LinearRgb& light) {
    const auto [r, g, b] = light;
    const double l = std::cbrt(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b);
    const double m = std::cbrt(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b);
    const double s = std::cbrt(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b);
    return {0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s,
            1.9779984951 * l - 2.4285922050 * m + 0.4505937099 * s,
            0.0259040371 * l + 0.7827717662 * m - 0.8086757660 * s};
}

double squaredDistance(const OkLab& a, const OkLab& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        sum += (a[i] - b[i]) * (a[i] - b[i]);
    }
    return sum;
}

} // namespace knittsim::pattern
