#include "ui/render/look.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace knittsim::render {

namespace {

double glossOf(std::string_view kind) {
    struct Gloss {
        std::string_view kind;
        double value;
    };
    constexpr std::array kGloss{Gloss{"lustrous", 0.9}, Gloss{"glossy", 0.8}, Gloss{"crimped", 0.4},
                                Gloss{"smooth", 0.35},  Gloss{"matte", 0.1},  Gloss{"hairy", 0.12},
                                Gloss{"bulky", 0.15},   Gloss{"halo", 0.15},  Gloss{"soft", 0.15}};
    const auto* found = std::ranges::find(kGloss, kind, &Gloss::kind);
    return found != kGloss.end() ? found->value : 0.25;
}

} // namespace

MeshColours meshColours(bool dark) {
    return dark ? MeshColours{{110, 200, 250}, {150, 226, 134}, {255, 128, 108}}
                : MeshColours{{10, 90, 170}, {22, 128, 50}, {200, 36, 24}};
}

YarnLook lookOf(const yarn::Yarn& yarn) {
    constexpr int kMostPlies = 6; // more are filaments, which the eye does not tell apart
    return {.colour = yarn.colour,
            .diameterMm = yarn.outerDiameterMm,
            .plies = yarn.surface.plies <= kMostPlies ? yarn.surface.plies : 1,
            .twistPerMetre = yarn.surface.twistPerMetre,
            .hairiness = std::clamp(yarn.surface.hairiness, 0.0, 1.0),
            .gloss = glossOf(yarn.surface.kind),
            .melange = std::clamp(yarn.surface.melange, 0.0, 1.0)};
}

} // namespace knittsim::render
