#pragma once

#include "core/machine/program.h"
#include "core/yarn/yarn_library.h"

#include <string>
#include <vector>

namespace knittsim::machine {

/// The yarn that a carrier feeds.
struct CarrierYarn {
    std::string carrier; ///< name of the carrier
    bool used = false;   ///< the program makes loops or floats with it
    yarn::Yarn yarn;     ///< with the colour that is shown

    bool operator==(const CarrierYarn&) const = default;
};

/// Yarns by carrier as a program asks for them: the library yarn whose id or name ';;Yarn-NAME:' gives, else
/// `fallback`. The colour is that of the carrier's first x-vis-color; carriers without one and without a
/// library yarn get different calm colours, so that they can be told apart.
std::vector<CarrierYarn> carrierYarns(const Program& program, const yarn::YarnLibrary& library,
                                      const yarn::Yarn& fallback);

/// By carrier, without the names.
std::vector<yarn::Yarn> yarnsOf(const std::vector<CarrierYarn>& carriers);

/// Only the colour and the surface differ, so that a change needs no physics.
bool sameBody(const yarn::Yarn& a, const yarn::Yarn& b);

} // namespace knittsim::machine
