#pragma once

#include "core/yarn/yarn.h"

#include <cstdint>

namespace knittsim::render {

/// How yarns are drawn.
enum class DrawStyle : std::uint8_t {
    Strokes, ///< the paper's three strokes: wide and dark, narrower, thin bright dotted
    Yarn,    ///< lit round yarn with plies
    Mesh,    ///< bonding points and the yarn between them, straight
};

/// How finely yarns are drawn, from far to near.
enum class DetailLevel : std::uint8_t {
    Strokes, ///< flat bands that are lit as if they were round
    Tubes,   ///< round, without plies
    Yarn,    ///< round, with plies and fibres
};

/// Colours of the bonding points in the bare mesh, by role.
struct MeshColours {
    yarn::Colour foot, head, crossing;
};
MeshColours meshColours(bool dark);

/// Width of a bonding point in the bare mesh, and its limits on the screen.
constexpr float kMarkerMm = 0.25F;
constexpr float kLeastMarkerPixels = 4;
constexpr float kMostMarkerPixels = 12;

/// What the renderer needs to know of a yarn. Plain value.
struct YarnLook {
    yarn::Colour colour;
    double diameterMm = 0.36; ///< as drawn: the hull of the fibres
    int plies = 2;
    double twistPerMetre = 300; ///< positive = S
    double hairiness = 0.3;     ///< 0..1
    double gloss = 0.3;         ///< 0 (chalk) .. 1 (silk)
    double melange = 0;         ///< 0..1

    bool operator==(const YarnLook&) const = default;
};

/// The look of a yarn; change `colour` afterwards where the program names another one.
YarnLook lookOf(const yarn::Yarn& yarn);

} // namespace knittsim::render
