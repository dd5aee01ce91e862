#pragma once

#include "core/yarn/yarn.h"

#include <array>

namespace knittsim::pattern {

/// Light of the three channels, linear, 0 to 1.
using LinearRgb = std::array<double, 3>;
/// Lightness and two axes of colour: Ottosson, "A perceptual color space for image processing" (2020).
using OkLab = std::array<double, 3>;

/// Of one sRGB byte (IEC 61966-2-1).
double linearOf(std::uint8_t channel);
std::uint8_t channelOf(double linear);

LinearRgb linearOf(yarn::Colour colour);
yarn::Colour colourOf(const LinearRgb& light);
OkLab okLabOf(const LinearRgb& light);

double squaredDistance(const OkLab& a, const OkLab& b);

} // namespace knittsim::pattern
