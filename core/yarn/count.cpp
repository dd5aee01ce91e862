#include "core/yarn/count.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace knittsim::yarn {

namespace {

constexpr double kEnglish = 590.54; ///< tex times Ne

} // namespace

const char* toString(CountSystem system) {
    switch (system) {
    case CountSystem::Tex:
        return "tex";
    case CountSystem::Dtex:
        return "dtex";
    case CountSystem::Den:
        return "den";
    case CountSystem::Nm:
        return "Nm";
    case CountSystem::Ne:
        break;
    }
    return "Ne";
}

double texOf(CountSystem system, double count) {
    if (!(count > 0)) {
        return 0;
    }
    switch (system) {
    case CountSystem::Tex:
        return count;
    case CountSystem::Dtex:
        return count / 10;
    case CountSystem::Den:
        return count / 9;
    case CountSystem::Nm:
        return 1000 / count;
    case CountSystem::Ne:
        break;
    }
    return kEnglish / count;
}

double countOf(CountSystem system, double tex) {
    switch (system) {
    case CountSystem::Tex:
        return tex;
    case CountSystem::Dtex:
        return tex * 10;
    case CountSystem::Den:
        return tex * 9;
    case CountSystem::Nm:
        return 1000 / tex;
    case CountSystem::Ne:
        break;
    }
    return kEnglish / tex;
}

std::string countText(CountSystem system, double tex) {
    const bool before = system == CountSystem::Nm || system == CountSystem::Ne;
    const double count = countOf(system, tex);
    return before ? fmt::format("{} {:.4g}", toString(system), count)
                  : fmt::format("{:.4g} {}", count, toString(system));
}

double diameterMm(double tex, double density, double packing) {
    return 2 * std::sqrt(tex / (1000 * std::numbers::pi * density * packing));
}

} // namespace knittsim::yarn
