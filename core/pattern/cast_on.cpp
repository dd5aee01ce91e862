#include "core/pattern/cast_on.h"

#include "core/pattern/backing.h"

#include <algorithm>

namespace knittsim::pattern {

using machine::Bed;
using machine::Needle;
using machine::OperationKind;

namespace {

bool needs(Bed bed, Stitch stitch) {
    return workOn(bed, stitch, Bed::Front) || (stitch == Stitch::Rest && bed == Bed::Front);
}

/// Needles of one bed that the first course works; of a tube, the first round.
std::vector<Needle> needlesOf(const Chart& chart, Bed bed) {
    const int courses = chart.beds == BedUse::Double ? std::min(2, chart.height()) : 1;
    std::vector<int> backs;
    for (int course = 0; course < courses; ++course) {
        for (const int yarn : yarnsOf(chart, course)) {
            std::ranges::copy(backingOf(chart, course, yarn), std::back_inserter(backs));
        }
    }
    std::ranges::sort(backs);
    std::vector<Needle> needles;
    for (int wale = 0; wale < chart.width; ++wale) {
        bool needed = false;
        for (int course = 0; course < courses; ++course) {
            needed = needed || needs(bed, chart.at(wale, course).stitch) ||
                     (bed == Bed::Rear && std::ranges::binary_search(backs, wale));
        }
        if (needed) {
            needles.push_back({bed, wale});
        }
    }
    return needles;
}

/// Every second needle, counted from the right end.
std::vector<Work> tucks(const std::vector<Needle>& needles, std::size_t parity, HeldLoops& held) {
    std::vector<Work> works;
    for (std::size_t i = 0; i < needles.size(); ++i) {
        if ((needles.size() - 1 - i) % 2 == parity) {
            works.push_back({OperationKind::Tuck, needles[i]});
            held.add(needles[i]);
        }
    }
    return works;
}

} // namespace

void castOnAlternating(const Chart& chart, Feeds& feeds, HeldLoops& held, ProgramBuilder& builder) {
    int yarn = -1;
    for (int wale = 0; wale < chart.width; ++wale) {
        yarn = isWorked(chart.at(wale, 0).stitch) ? chart.at(wale, 0).yarn : yarn;
    }
    if (yarn < 0) {
        return;
    }
    const double rack = rackOf(chart, 0);
    builder.rack(rack);
    std::vector<Needle> front = needlesOf(chart, Bed::Front);
    const std::vector<Needle> rear = needlesOf(chart, Bed::Rear);
    if (chart.beds == BedUse::Double && !worksBothBeds(chart, 0)) {
        for (const std::size_t parity : {0U, 1U}) {
            feeds.pass(yarn, tucks(front, parity, held), builder);
            feeds.pass(yarn, tucks(rear, parity, held), builder);
        }
    } else {
        front.insert(front.end(), rear.begin(), rear.end());
        std::ranges::stable_sort(front, {}, [&](Needle needle) { return positionPitches(needle, rack); });
        feeds.pass(yarn, tucks(front, 0, held), builder);
        feeds.pass(yarn, tucks(front, 1, held), builder);
    }
    feeds.release(yarn, builder);
}

} // namespace knittsim::pattern
