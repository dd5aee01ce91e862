#pragma once

#include <string>
#include <string_view>

namespace knittsim::formats::kcode {

/// The needles of a FRNT or REAR line.
struct NeedleLine {
    std::string works; ///< one of kWorks, kRests for each needle from the left
    int badColumn = 0; ///< 1-based place of the first sign that does not belong there, 0: none
};

/// Takes the margins and the stops of carrier and carriage away.
NeedleLine readNeedleLine(std::string_view text);

} // namespace knittsim::formats::kcode
