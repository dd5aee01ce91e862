#pragma once

#include <compare>
#include <cstdint>
#include <string>

namespace knittsim::machine {

/// Sliders are the second hooks of some machines; they hold loops but never make one.
enum class Bed : std::uint8_t { Front, Rear, FrontSlider, RearSlider };

constexpr int kBedCount = 4;

constexpr bool isFront(Bed bed) {
    return bed == Bed::Front || bed == Bed::FrontSlider;
}
constexpr bool isSlider(Bed bed) {
    return bed == Bed::FrontSlider || bed == Bed::RearSlider;
}

/// A needle of one bed. Negative indices are legal (knitout 2).
struct Needle {
    Bed bed = Bed::Front;
    std::int32_t index = 0;

    auto operator<=>(const Needle&) const = default;
};

/// Position along the front bed in needle pitches; rear needle B lies at B + rack (FORMATS: knitout 2,
/// racking).
constexpr double positionPitches(Needle needle, double rack) {
    return isFront(needle.bed) ? needle.index : needle.index + rack;
}

/// "f5", "b-3", "fs2", "bs0" as knitout writes them.
std::string toString(Needle needle);

} // namespace knittsim::machine
