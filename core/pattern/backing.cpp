#include "core/pattern/backing.h"

#include "core/pattern/course_works.h"

#include <algorithm>

namespace knittsim::pattern {

namespace {

bool leavesRearNeedle(Stitch stitch) {
    return stitch == Stitch::Knit || stitch == Stitch::Tuck || stitch == Stitch::Miss;
}

/// Yarn that knits the ladder of this wale.
int ladderYarn(const Chart& chart, int course, int wale, std::vector<int> yarns) {
    if (yarns.size() > 1) {
        std::erase(yarns, chart.at(wale, course).yarn);
    }
    return yarns[static_cast<std::size_t>(course + wale / kLadderStep) % yarns.size()];
}

} // namespace

std::vector<int> backingOf(const Chart& chart, int course, int yarn) {
    const ColourMethod method = chart.course(course).colours;
    std::vector<int> wales;
    if (!isBacked(method)) {
        return wales;
    }
    const std::vector<int> yarns = yarnsOf(chart, course);
    if (!std::ranges::binary_search(yarns, yarn)) {
        return wales;
    }
    const auto place = std::ranges::find(yarns, yarn) - yarns.begin();
    for (int wale = 0; wale < chart.width; ++wale) {
        const bool here = method == ColourMethod::Birdseye
                              ? (wale + course + place) % 2 == 0
                              : wale % kLadderStep == 0 && ladderYarn(chart, course, wale, yarns) == yarn;
        if (here && leavesRearNeedle(chart.at(wale, course).stitch)) {
            wales.push_back(wale);
        }
    }
    return wales;
}

} // namespace knittsim::pattern
