#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>

namespace knittsim::yarn {

struct Colour {
    std::uint8_t r = 200;
    std::uint8_t g = 200;
    std::uint8_t b = 200;

    bool operator==(const Colour&) const = default;
};

/// What the eye sees of a yarn.
struct Surface {
    std::string kind =
        "smooth";           ///< smooth, hairy, bulky, matte, glossy, lustrous, crimped, slubby, halo, soft
    double hairiness = 0.3; ///< 0 (none) .. 1 (brushed mohair)
    int plies = 2;
    double twistPerMetre = 300; ///< turns of the plies per metre; positive = S
    double melange = 0;         ///< 0 (solid) .. 1 (strongly mixed) colour variation along the yarn

    bool operator==(const Surface&) const = default;
};

/// A yarn as the simulation sees it. All numbers per single yarn as it runs through a carrier.
struct Yarn {
    std::string id;
    std::string name;
    std::string fibre;
    std::string count;                       ///< as the trade writes it, for example "Nm 2/30"
    double tex = 67;                         ///< linear density, g/km
    double outerDiameterMm = 0.36;           ///< hull of the fibres
    double coreDiameterMm = 0.27;            ///< packed fibres: the hard part
    double axialStiffnessMilliNewton = 38e3; ///< EA, mN
    double bendingStiffness = 8.7;           ///< EI, mN mm^2
    double friction = 0.22;                  ///< yarn on yarn, Coulomb
    Colour colour;
    Surface surface;
    std::map<std::string, std::string> sources; ///< JSON key -> where its number comes from
    std::string note;

    double nm() const { return 1000.0 / tex; } ///< metres per gram
    double ne() const { return 590.54 / tex; } ///< English cotton count

    bool operator==(const Yarn&) const = default;
};

} // namespace knittsim::yarn
