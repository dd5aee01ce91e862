#include "core/machine/choose_profile.h"

namespace knittsim::machine {

MachineProfile chooseProfile(const Header& header) {
    MachineProfile profile = genericProfile();
    if (header.gauge && *header.gauge > 0) {
        const double scale = profile.gauge / *header.gauge;
        profile.gauge = *header.gauge;
        profile.bedGapMm *= scale;
        profile.defaultLoopLengthMm *= scale;
        for (auto& [number, length] : profile.stitchTable) {
            length *= scale;
        }
    }
    return profile;
}

} // namespace knittsim::machine
