#include "core/pattern/backing.h"
#include "core/pattern/catalogue.h"
#include "core/pattern/chart_edit.h"
#include "core/pattern/course_works.h"
#include "core/pattern/swatch.h"
#include "lifted_back.h"

#include <array>
#include <random>

/// Charts that are compiled, knitted by the emulated machine and lifted back are the same charts.
namespace knittsim::pattern {
namespace {

/// Stitches on both beds, modules of the catalogue, several colours; every wale is worked in every course.
Chart randomChart(std::mt19937& random) {
    const auto upTo = [&](int most) { return std::uniform_int_distribution<int>(0, most)(random); };
    Chart chart(8 + upTo(16), 6 + upTo(16));
    chart.yarns = {{"1", {}, ""}, {"2", {}, ""}, {"3", {}, ""}};
    const int colours = upTo(2);
    for (int c = 0; c < chart.height(); ++c) {
        for (int w = 0; w < chart.width; ++w) {
            chart.at(w, c) = {upTo(3) == 0 ? Stitch::Purl : Stitch::Knit,
                              static_cast<std::uint8_t>(upTo(colours))};
        }
    }
    for (int i = upTo(4); i > 0; --i) {
        const Module& module =
            catalogue()[static_cast<std::size_t>(upTo(static_cast<int>(catalogue().size()) - 1))];
        if (module.tiles) { // not the first courses: loops are moved and held
            tile(chart, {upTo(chart.width - 4), 2 + upTo(chart.height() - 4), 2 + upTo(12), 2 + upTo(12)},
                 module.part, PasteWhat::Stitches);
        }
    }
    return chart;
}

TEST(LiftChart, RandomChartsComeBack) {
    std::mt19937 random(7);
    for (int i = 0; i < 300 && !testing::Test::HasFailure(); ++i) {
        expectNone(randomChart(random), liftsBack, i);
    }
}

TEST(LiftChart, EveryModuleOfTheCatalogueComesBack) {
    for (const Module& module : catalogue()) {
        Chart chart = plainChart(24, 30);
        if (module.tiles) {
            tile(chart, {4, 4, 16, 20}, module.part, PasteWhat::Stitches);
        } else {
            const bool left = module.part.at(0, 0).stitch == Stitch::Empty;
            paste(chart, {left ? 0 : chart.width - module.part.width, chart.height() - module.part.height()},
                  module.part, PasteWhat::Stitches);
        }
        EXPECT_EQ(liftsBack(chart), "") << module.id;
    }
}

TEST(LiftChart, RandomChartsPassTheChecks) {
    std::mt19937 random(11);
    for (int i = 0; i < 200 && !testing::Test::HasFailure(); ++i) {
        expectNone(randomChart(random), firstError, i);
    }
}

/// Zones of random widths that wander.
Chart zones(std::mt19937& random) {
    const auto upTo = [&](int most) { return std::uniform_int_distribution<int>(0, most)(random); };
    Chart chart(9 + upTo(12), 4 + upTo(12));
    chart.yarns = {{"1", {}, ""}, {"2", {}, ""}, {"3", {}, ""}};
    int first = 3;
    int second = chart.width - 3;
    for (int c = 0; c < chart.height(); ++c) {
        chart.course(c).colours = ColourMethod::Intarsia;
        first = std::clamp(first + upTo(2) - 1, 2, chart.width / 2 - 1);
        second = std::clamp(second + upTo(2) - 1, chart.width / 2 + 1, chart.width - 2);
        for (int w = 0; w < chart.width; ++w) {
            chart.at(w, c) = {upTo(4) == 0 ? Stitch::Purl : Stitch::Knit,
                              static_cast<std::uint8_t>(w < first    ? 0
                                                        : w < second ? 1
                                                                     : 2)};
        }
    }
    return chart;
}

TEST(LiftChart, IntarsiaComesBack) {
    std::mt19937 random(23);
    for (int i = 0; i < 200 && !testing::Test::HasFailure(); ++i) {
        expectNone(zones(random), liftsBack, i);
    }
}

/// Every stitch that two beds can make, rackings, up to three colours; the first course works all needles.
Chart doubleChart(std::mt19937& random) {
    const auto upTo = [&](int most) { return std::uniform_int_distribution<int>(0, most)(random); };
    constexpr std::array kAll{Stitch::Knit,     Stitch::Knit,     Stitch::Knit,     Stitch::Purl,
                              Stitch::Purl,     Stitch::Both,     Stitch::Both,     Stitch::Tuck,
                              Stitch::Miss,     Stitch::KnitTuck, Stitch::TuckKnit, Stitch::TuckBoth,
                              Stitch::RearTuck, Stitch::RearMiss};
    Chart chart(8 + upTo(12), 5 + upTo(12), Stitch::Both);
    chart.beds = BedUse::Double;
    chart.yarns = {{"1", {}, ""}, {"2", {}, ""}, {"3", {}, ""}};
    const int colours = upTo(2);
    for (int c = 1; c < chart.height(); ++c) {
        chart.course(c).rack = upTo(5) == 0 ? 1 : 0;
        for (int w = 0; w < chart.width; ++w) {
            chart.at(w, c) = {kAll[static_cast<std::size_t>(upTo(static_cast<int>(kAll.size()) - 1))],
                              static_cast<std::uint8_t>(upTo(colours))};
        }
    }
    return chart;
}

TEST(LiftChart, ChartsOnTwoBedsComeBack) {
    std::mt19937 random(31);
    for (int i = 0; i < 300 && !testing::Test::HasFailure(); ++i) {
        expectNone(doubleChart(random), liftsBack, i);
    }
}

TEST(LiftChart, ChartsOnTwoBedsPassTheChecks) {
    std::mt19937 random(37);
    for (int i = 0; i < 200 && !testing::Test::HasFailure(); ++i) {
        expectNone(doubleChart(random), firstError, i);
    }
}

/// Two to four colours in patches, here and there another stitch, also on both beds; the back is knitted by
/// one method.
Chart backedChart(std::mt19937& random) {
    const auto upTo = [&](int most) { return std::uniform_int_distribution<int>(0, most)(random); };
    Chart chart(8 + upTo(16), 5 + upTo(12));
    chart.beds = BedUse::Double;
    chart.yarns = {{"1", {}, ""}, {"2", {}, ""}, {"3", {}, ""}, {"4", {}, ""}};
    const int colours = 1 + upTo(2);
    const ColourMethod method = upTo(1) == 0 ? ColourMethod::Birdseye : ColourMethod::LadderBack;
    for (int c = 0; c < chart.height(); ++c) {
        chart.course(c).colours = method;
        const bool plain = upTo(3) == 0; // courses of one yarn among them
        for (int w = 0; w < chart.width; ++w) {
            const bool same = w > 0 && upTo(2) > 0;
            const auto yarn = static_cast<std::uint8_t>(plain ? 0 : upTo(colours));
            chart.at(w, c) = {Stitch::Knit, same ? chart.at(w - 1, c).yarn : yarn};
        }
        for (int i = c > 0 ? upTo(2) : 0; i > 0; --i) {
            static constexpr std::array kOthers{Stitch::Tuck, Stitch::Miss, Stitch::Both, Stitch::Both,
                                                Stitch::TuckKnit};
            chart.at(upTo(chart.width - 1), c).stitch =
                kOthers[static_cast<std::size_t>(upTo(static_cast<int>(kOthers.size()) - 1))];
        }
    }
    return chart;
}

/// Every course has a back, and some rear needle knits a yarn that the front does not show: no other stitches
/// look the same.
bool showsItsBack(const Chart& chart) {
    bool shows = false;
    for (int c = 0; c < chart.height(); ++c) {
        if (!isBacked(chart.course(c).colours)) {
            return false;
        }
        for (const int yarn : yarnsOf(chart, c)) {
            for (const int wale : backingOf(chart, c, yarn)) {
                shows = shows || chart.at(wale, c).yarn != yarn;
            }
        }
    }
    return shows;
}

/// Of two charts that are knitted alike the simpler one: the back behind a cell may be what a stitch on both
/// beds would do.
Chart simplest(Chart chart) {
    for (int c = 0; c < chart.height(); ++c) {
        for (int w = 0; w < chart.width; ++w) {
            const Cell before = chart.at(w, c);
            if (before.stitch != Stitch::Both && before.stitch != Stitch::TuckKnit) {
                continue;
            }
            chart.at(w, c).stitch = before.stitch == Stitch::Both ? Stitch::Knit : Stitch::Tuck;
            for (const int yarn : yarnsOf(chart, c)) {
                const std::vector<int> back = backingOf(chart, c, yarn);
                const bool knits = std::ranges::binary_search(back, w);
                if (knits != (yarn == before.yarn)) {
                    chart.at(w, c) = before;
                    break;
                }
            }
        }
    }
    return chart;
}

bool startsPlain(const Chart& chart) {
    return std::all_of(chart.cells.begin(), chart.cells.begin() + chart.width,
                       [](const Cell& cell) { return cell.stitch == Stitch::Knit; });
}

TEST(LiftChart, BackedColoursComeBack) {
    std::mt19937 random(41);
    int shown = 0;
    for (int i = 0; i < 300 && !testing::Test::HasFailure(); ++i) {
        const Chart chart = simplest(backedChart(random));
        shown += showsItsBack(chart) ? 1 : 0;
        expectNone(
            chart,
            [](const Chart& c) {
                return startsPlain(c) && showsItsBack(c) && simplest(c) == c ? liftsBack(c) : std::string();
            },
            i);
    }
    EXPECT_GE(shown, 280);
}

TEST(LiftChart, BackedColoursPassTheChecks) {
    std::mt19937 random(43);
    for (int i = 0; i < 200 && !testing::Test::HasFailure(); ++i) {
        expectNone(backedChart(random), firstError, i);
    }
}

TEST(LiftChart, DroppedLoopsComeBack) {
    std::mt19937 random(47);
    const auto upTo = [&](int most) { return std::uniform_int_distribution<int>(0, most)(random); };
    for (int i = 0; i < 100 && !testing::Test::HasFailure(); ++i) {
        Chart chart = ribChart(6 + upTo(10), 4 + upTo(8), 1 + upTo(2), 1 + upTo(2));
        for (int wale = upTo(3); wale + 1 < chart.width; wale += 1 + upTo(4)) {
            const int from = 1 + upTo(chart.height() - 2);
            const int until = std::min(from + 1 + upTo(chart.height()), chart.height());
            for (int c = from; c < until; ++c) { // and empty from there on, or knitted again
                chart.at(wale, c).stitch = c == from ? Stitch::Drop : Stitch::Empty;
            }
        }
        ASSERT_EQ(liftsBack(chart), "") << drawn(chart);
    }
}

TEST(LiftChart, LargeChartsComeBack) {
    // 300 x 500, with a cable in every eighth course.
    Chart chart = plainChart(300, 500);
    for (int c = 4; c < chart.height(); c += 8) {
        for (int w = 0; w + 4 <= chart.width; w += 8) {
            const auto moves = cross(w, 2, 2, Front::Left);
            chart.course(c).moves.insert(chart.course(c).moves.end(), moves.begin(), moves.end());
        }
    }
    EXPECT_EQ(liftsBack(chart), "");
}

} // namespace
} // namespace knittsim::pattern
