#include "ui/render/colour_scale.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace knittsim::render {
namespace {

double linear(std::uint8_t channel) {
    const double c = channel / 255.0;
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

/// Oklab lightness.
double lightness(yarn::Colour colour) {
    const double r = linear(colour.r);
    const double g = linear(colour.g);
    const double b = linear(colour.b);
    return 0.2104542553 * std::cbrt(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b) +
           0.7936177850 * std::cbrt(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b) -
           0.0040720468 * std::cbrt(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b);
}

/// Who tells no hues apart reads the value by lightness.
TEST(ColourScale, RisesEvenlyInLightness) {
    for (std::size_t i = 0; i < kRampColours; ++i) {
        const double share = static_cast<double>(i) / (kRampColours - 1);
        EXPECT_NEAR(lightness(ramp()[i]), 0.36 + 0.56 * share, 0.01) << i;
    }
    EXPECT_EQ(rampColour(-1), ramp().front());
    EXPECT_EQ(rampColour(2), ramp().back());
    EXPECT_EQ(rampColour(0.5F), ramp()[kRampColours / 2]);
}

TEST(ColourScale, RunsBetweenRoundLimits) {
    std::vector<float> values;
    for (int i = 0; i <= 1000; ++i) {
        values.push_back(0.0375F * static_cast<float>(i));
    }
    values.push_back(5000); // a loose end that sticks out
    const ValueRange range = rangeOf(values);
    EXPECT_EQ(range.low, 0);
    EXPECT_FLOAT_EQ(range.high, 40);
    EXPECT_FLOAT_EQ(range.step, 10);
    EXPECT_FLOAT_EQ(range.shareOf(20), 0.5F);
    EXPECT_EQ(range.shareOf(5000), 1);
    EXPECT_EQ(range.shareOf(-3), 0);
}

TEST(ColourScale, BeginsBelowZeroWhereValuesDo) {
    std::vector<float> values;
    for (int i = -300; i <= 1000; ++i) {
        values.push_back(static_cast<float>(i));
    }
    const ValueRange range = rangeOf(values);
    EXPECT_FLOAT_EQ(range.low, -500);
    EXPECT_FLOAT_EQ(range.high, 1000);
}

TEST(ColourScale, OfNothingOrOfNothingButZeroIsEmpty) {
    EXPECT_TRUE(rangeOf({}).empty());
    EXPECT_TRUE(rangeOf(std::vector<float>(10, 0.0F)).empty());
    EXPECT_TRUE(rangeOf(std::vector<float>(3, std::numeric_limits<float>::quiet_NaN())).empty());
}

} // namespace
} // namespace knittsim::render
