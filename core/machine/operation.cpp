#include "core/machine/operation.h"

#include <array>

namespace knittsim::machine {

std::string toString(Needle needle) {
    constexpr std::array<const char*, kBedCount> kNames{"f", "b", "fs", "bs"};
    return kNames[static_cast<std::size_t>(needle.bed)] + std::to_string(needle.index);
}

const char* toString(OperationKind kind) {
    constexpr std::array<const char*, kOperationKindCount> kNames{
        "in",   "inhook", "releasehook", "out",       "outhook",    "stitch",   "x-stitch-number",
        "rack", "knit",   "tuck",        "split",     "drop",       "amiss",    "xfer",
        "miss", "pause",  "x-vis-color", "x-yarn-in", "x-yarn-out", "extension"};
    return kNames[static_cast<std::size_t>(kind)];
}

} // namespace knittsim::machine
