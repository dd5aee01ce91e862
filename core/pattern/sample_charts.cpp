#include "core/pattern/sample_charts.h"

#include <algorithm>
#include <cstdlib>

namespace knittsim::pattern {

namespace {

const ChartYarn kCream{"1", {0xe9, 0xdf, 0xc8}, "merino-2-30"};
const ChartYarn kNavy{"2", {0x24, 0x3b, 0x5e}, "merino-2-30"};
const ChartYarn kRust{"3", {0xb5, 0x52, 0x33}, "acrylic-hb-2-28"};
const ChartYarn kForest{"4", {0x3f, 0x6b, 0x4f}, "acrylic-hb-2-28"};
const ChartYarn kMustard{"5", {0xd9, 0xa6, 0x2e}, "acrylic-hb-2-28"};
const ChartYarn kPlum{"6", {0x6d, 0x35, 0x5a}, "viscose-2-30"};
const ChartYarn kOatmeal{"7", {0xcb, 0xb3, 0x96}, "cashmere-2-26"};
const ChartYarn kTeal{"8", {0x1f, 0x6f, 0x78}, "merino-2-48"};

void setCourse(Chart& chart, int course, Stitch stitch, int yarn) {
    for (int wale = 0; wale < chart.width; ++wale) {
        chart.at(wale, course) = {stitch, static_cast<std::uint8_t>(yarn)};
    }
}

/// Knit wales from `wale` up to the top.
void setKnitWales(Chart& chart, int wale, int count) {
    for (int course = 0; course < chart.height(); ++course) {
        for (int i = 0; i < count; ++i) {
            chart.at(wale + i, course).stitch = Stitch::Knit;
        }
    }
}

void addMoves(Course& course, const std::vector<LoopMove>& moves) {
    course.moves.insert(course.moves.end(), moves.begin(), moves.end());
}

/// Fully fashioned: the three outer loops of both edges go inwards, the innermost of them onto its neighbour.
void narrow(Chart& chart, int course, int edge) {
    const int last = chart.width - 1 - edge;
    addMoves(chart.course(course), {{edge + 2, edge + 3},
                                    {edge + 1, edge + 2},
                                    {edge, edge + 1},
                                    {last - 2, last - 3},
                                    {last - 1, last - 2},
                                    {last, last - 1}});
}

} // namespace

Chart cableChart(Front front) {
    Chart chart(28, 36, Stitch::Purl);
    chart.yarns = {front == Front::Right ? kCream : kOatmeal};
    for (int wale = 4; wale < chart.width; wale += 8) {
        setKnitWales(chart, wale, 4);
        for (int course = 5; course < chart.height() - 2; course += 6) {
            addMoves(chart.course(course), cross(wale, 2, 2, front));
        }
    }
    return chart;
}

Chart braidChart() {
    Chart chart(30, 40, Stitch::Purl);
    chart.yarns = {kMustard};
    for (int wale = 3; wale < chart.width; wale += 9) {
        setKnitWales(chart, wale, 6);
        for (int course = 4; course < chart.height() - 2; course += 4) {
            const bool even = course % 8 == 4;
            addMoves(chart.course(course),
                     even ? cross(wale, 2, 2, Front::Left) : cross(wale + 2, 2, 2, Front::Right));
        }
    }
    return chart;
}

Chart laceChart() {
    constexpr int kRepeat = 9;
    constexpr int kCentre = 4;
    Chart chart(3 * kRepeat + 2, 38);
    chart.yarns = {kTeal};
    for (int bottom = 4; bottom + 8 < chart.height(); bottom += 10) {
        for (int left = 1; left + kRepeat < chart.width; left += kRepeat) {
            for (int step = 0; step < kCentre; ++step) {
                // Towards the centre from both sides; the last pair stacks three loops there.
                const int right = left + kRepeat - 1;
                addMoves(chart.course(bottom + 2 * step),
                         {{left + step, left + step + 1}, {right - step, right - step - 1}});
            }
        }
    }
    return chart;
}

Chart ladderChart() {
    constexpr int kOpened = 10; // course
    Chart chart(29, 36);
    chart.yarns = {kPlum};
    for (const int wale : {5, 6, 22, 23}) {
        for (int course = 0; course < chart.height(); ++course) {
            chart.at(wale, course).stitch = Stitch::Empty;
        }
    }
    // One that begins in the middle: its loop goes to the next wale, and its needle rests from there on.
    addMoves(chart.course(kOpened), {{14, 15}});
    for (int course = kOpened; course < chart.height(); ++course) {
        chart.at(14, course).stitch = Stitch::Empty;
    }
    return chart;
}

Chart tuckChart() {
    Chart chart(29, 40);
    chart.yarns = {kCream, kForest};
    for (int course = 0; course < chart.height(); ++course) {
        const bool tucked = course >= 4 && course < chart.height() - 2 && course % 4 >= 2;
        setCourse(chart, course, Stitch::Knit, tucked ? 1 : 0);
        for (int wale = course % 8 < 4 ? 2 : 4; tucked && wale < chart.width - 1; wale += 4) {
            chart.at(wale, course).stitch = Stitch::Tuck;
        }
    }
    return chart;
}

Chart slipChart() {
    Chart chart(29, 40);
    chart.yarns = {kPlum, kOatmeal};
    for (int course = 0; course < chart.height(); ++course) {
        const bool ground = course < 4 || course >= chart.height() - 2;
        const int yarn = ground ? 0 : course / 2 % 2;
        setCourse(chart, course, Stitch::Knit, yarn);
        for (int wale = yarn == 0 ? 2 : 4; !ground && wale < chart.width - 1; wale += 4) {
            chart.at(wale, course).stitch = Stitch::Miss;
        }
    }
    return chart;
}

Chart floatJacquardChart() {
    constexpr int kRepeat = 12;
    constexpr int kBorder = 4;
    Chart chart(29, 41);
    chart.yarns = {kNavy, kCream};
    const auto fromCentre = [](int position, int centre) {
        const int distance = std::abs(position - centre) % kRepeat;
        return std::min(distance, kRepeat - distance);
    };
    for (int course = kBorder; course < chart.height() - kBorder; ++course) {
        for (int wale = 0; wale < chart.width; ++wale) {
            // Nested diamonds, three wales thick: no float passes more than five needles.
            const int ring = fromCentre(wale, chart.width / 2) + fromCentre(course, chart.height() / 2);
            chart.at(wale, course).yarn = ring % 6 < 3 ? 1 : 0;
        }
    }
    return chart;
}

Chart intarsiaChart() {
    constexpr int kBorder = 4;
    Chart chart(28, 38);
    chart.yarns = {kRust, kMustard, kForest};
    const int zoned = chart.height() - 2 * kBorder;
    for (int i = 0; i < zoned; ++i) {
        const int course = kBorder + i;
        const int half = 2 + std::min(i, zoned - 1 - i) / 2;
        chart.course(course).colours = ColourMethod::Intarsia;
        for (int wale = 0; wale < chart.width; ++wale) {
            const int fromMiddle = wale - chart.width / 2;
            chart.at(wale, course).yarn = fromMiddle < -half ? 2 : fromMiddle < half ? 1 : 0;
        }
    }
    return chart;
}

Chart tubeChart() {
    Chart chart(18, 48);
    chart.beds = BedUse::Double;
    chart.yarns = {kNavy, kRust};
    for (int course = 0; course < chart.height(); ++course) {
        setCourse(chart, course, course % 2 == 0 ? Stitch::Knit : Stitch::Purl, course / 8 % 2);
    }
    return chart;
}

Chart shortRowsChart() {
    constexpr int kGround = 6;
    constexpr int kStep = 4;
    const int wedge = 2 * 6;
    Chart chart(28, 3 * (kGround + wedge) + kGround);
    chart.yarns = {kCream, kPlum, kTeal, kMustard};
    for (int bottom = kGround; bottom < chart.height(); bottom += kGround + wedge) {
        const int colour = 1 + bottom / (kGround + wedge);
        for (int row = 0; row < wedge; ++row) {
            const int turn = kStep * (row / 2 + 1);
            setCourse(chart, bottom + row, Stitch::Knit, colour);
            for (int wale = 0; wale < turn; ++wale) {
                // The tuck on the first resting wale closes the hole where the carrier turns.
                const bool tucked = row % 2 == 0 && wale == turn - 1;
                chart.at(wale, bottom + row).stitch = tucked ? Stitch::Tuck : Stitch::Rest;
            }
        }
    }
    return chart;
}

Chart rackedRibChart() {
    constexpr int kReach = 4;
    Chart chart(22, 36, Stitch::Both);
    chart.beds = BedUse::Double;
    chart.yarns = {kForest};
    for (int course = 2; course < chart.height(); ++course) {
        const int phase = (course - 2) % (2 * kReach);
        chart.course(course).rack = std::min(phase, 2 * kReach - phase);
    }
    return chart;
}

Chart transferChart() {
    constexpr int kWanderFrom = 4;
    constexpr int kNarrowFrom = 26;
    constexpr int kRim = 4;
    Chart chart(28, 42, Stitch::Purl);
    chart.yarns = {kOatmeal};
    int left = 5; // the left strand; the right one is its mirror image
    int edge = 0;
    for (int course = 0; course < chart.height(); ++course) {
        const int step = (course - kWanderFrom) / 2;
        if (course % 2 == 0 && step >= 0 && step < 10) {
            // Each strand passes in front of the purl wale beside it.
            const int right = chart.width - 2 - left;
            if (step < 5) {
                addMoves(chart.course(course), cross(left++, 2, 1, Front::Left));
                addMoves(chart.course(course), cross(right - 1, 1, 2, Front::Right));
            } else {
                addMoves(chart.course(course), cross(--left, 1, 2, Front::Right));
                addMoves(chart.course(course), cross(right, 2, 1, Front::Left));
            }
        }
        if (course % 2 == 0 && course >= kNarrowFrom) {
            narrow(chart, course, edge++);
        }
        for (int wale = 0; wale < chart.width; ++wale) {
            const int inward = std::min(wale, chart.width - 1 - wale);
            const bool knit =
                inward < edge + kRim || course >= kNarrowFrom || inward == left || inward == left + 1;
            chart.at(wale, course).stitch = inward < edge ? Stitch::Empty
                                            : knit        ? Stitch::Knit
                                                          : Stitch::Purl;
        }
    }
    return chart;
}

} // namespace knittsim::pattern
