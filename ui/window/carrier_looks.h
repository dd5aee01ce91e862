#pragma once

#include "core/machine/carrier_yarns.h"
#include "ui/render/look.h"

#include <vector>

namespace knittsim::ui {

/// How the yarns on the carriers look; by carrier.
inline std::vector<render::YarnLook> looksOf(const std::vector<machine::CarrierYarn>& carriers) {
    std::vector<render::YarnLook> looks;
    looks.reserve(carriers.size());
    for (const machine::CarrierYarn& carrier : carriers) {
        looks.push_back(render::lookOf(carrier.yarn));
    }
    return looks;
}

} // namespace knittsim::ui
