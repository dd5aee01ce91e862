#pragma once

namespace knittsim::geometry {

/// The three strokes that draw a yarn: a wide dark one, on it a narrower one in the yarn's colour, on that
/// thin bright dots. In diameters of the yarn, where nothing else is said.
struct StrokeStyle {
    static constexpr double kBodyWidth = 0.60;
    static constexpr double kDotWidth = 0.16;
    static constexpr double kDotEvery = 0.7;
    static constexpr double kDotLength = 0.56 * kDotEvery;
    static constexpr double kEdgeShade = 0.22; ///< brightness of the dark stroke, of the yarn's colour
    static constexpr double kDotShare = 0.28;  ///< of the yarn's colour in a dot, else white
};

} // namespace knittsim::geometry
