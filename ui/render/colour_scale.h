#pragma once

#include "core/yarn/yarn.h"

#include <array>
#include <cstdint>
#include <span>

namespace knittsim::render {

/// What the colour of a yarn tells.
enum class ColourBy : std::uint8_t {
    Yarn,    ///< which yarn it is
    Tension, ///< mN
    Contact, ///< force of other yarn on it, mN by mm
    Speed,   ///< way since the shape shown before, mm
};

/// Values between which the colours run. Empty: there is nothing to tell.
struct ValueRange {
    float low = 0; ///< whole multiples of step
    float high = 0;
    float step = 1; ///< 1, 2 or 5 times a power of ten: what a legend names

    bool empty() const { return !(high > low); }
    float shareOf(float value) const; ///< 0 at `low`, 1 at `high`, not beyond
};

/// Round limits that hold 0 and all values but the two per cent at each end that stick out; from 0 where no
/// values to speak of lie below.
ValueRange rangeOf(std::span<const float> values);

/// Colours from low to high, evenly spaced. Their lightness (Oklab) rises evenly from 0.36 to 0.92, so they
/// can be read without telling hues apart.
constexpr std::size_t kRampColours = 7;
const std::array<yarn::Colour, kRampColours>& ramp();
yarn::Colour rampColour(float share);

} // namespace knittsim::render
