#include "core/formats/kcode/needle_line.h"

#include "core/formats/kcode/layout.h"

namespace knittsim::formats::kcode {

namespace {

bool isStop(char sign) {
    return sign == kLeftStop || sign == kRightStop || (sign >= '1' && sign <= '0' + kCarriers);
}

} // namespace

NeedleLine readNeedleLine(std::string_view text) {
    NeedleLine line;
    int margin = 0; // signs of the margin before, then behind the needles
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char sign = text[i];
        if (isStop(sign)) {
            continue;
        }
        const bool needle = sign == kWorks || sign == kRests;
        const bool behind = margin > kMargin;
        const bool good = sign == kMarginSign ? margin < 2 * kMargin && (margin != 0 || i <= 4 * kMargin)
                                              : needle && margin >= kMargin && !behind;
        if (!good) {
            line.badColumn = static_cast<int>(i) + 1;
            return line;
        }
        if (needle) {
            line.works += sign;
        } else {
            ++margin;
        }
    }
    if (margin != 2 * kMargin || line.works.empty()) {
        line.badColumn = static_cast<int>(text.size()) + 1;
    }
    return line;
}

} // namespace knittsim::formats::kcode
