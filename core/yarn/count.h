#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace knittsim::yarn {

/// How the trade writes how fine a yarn is.
enum class CountSystem : std::uint8_t {
    Tex,  ///< g per 1000 m
    Dtex, ///< g per 10 000 m
    Den,  ///< denier: g per 9000 m
    Nm,   ///< metric: m per g
    Ne,   ///< English cotton: hanks of 840 yards per pound; 590.54 / tex
};
inline constexpr std::array kCountSystems{CountSystem::Tex, CountSystem::Dtex, CountSystem::Den,
                                          CountSystem::Nm, CountSystem::Ne};

/// "tex", "dtex", "den", "Nm", "Ne"
const char* toString(CountSystem system);

/// The linear density, g/km, of a count; a count of 0 or less has none: 0.
double texOf(CountSystem system, double count);
/// The count of a linear density above 0.
double countOf(CountSystem system, double tex);

/// As the trade writes it, four digits: "Nm 15", "66.67 tex".
std::string countText(CountSystem system, double tex);

/// Diameter, mm, of a round section of which the fibres fill a part:
/// d = 2 sqrt(tex / (1000 pi density packing)) = 0.03568 sqrt(tex / (density packing)).
/// `density` of the fibre, g/cm3; `packing` 0 to 1 (resources/yarns/README.md lists usual ones).
double diameterMm(double tex, double density, double packing);

} // namespace knittsim::yarn
