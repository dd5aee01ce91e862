#include "knitted.h"

#include <random>

namespace knittsim::pattern {
namespace {

using machine::Bed;
using machine::Loop;
using machine::LoopIndex;
using machine::Operation;
using machine::Program;
using machine::Timeline;

/// Any well-formed chart without moves must compile into something that the machine can do.
Chart randomChart(std::mt19937& random, BedUse beds) {
    const auto upTo = [&](int most) { return std::uniform_int_distribution<int>(0, most)(random); };
    Chart chart(1 + upTo(9), 1 + upTo(9));
    chart.beds = beds;
    chart.yarns = {{"1", {}, ""}, {"2", {}, ""}, {"3", {}, ""}};
    std::vector<Stitch> stitches{Stitch::Knit, Stitch::Knit, Stitch::Purl,
                                 Stitch::Tuck, Stitch::Miss, Stitch::Rest};
    if (beds == BedUse::Double) {
        stitches.push_back(Stitch::Both);
    }
    for (Cell& cell : chart.cells) {
        cell = {stitches[static_cast<std::size_t>(upTo(static_cast<int>(stitches.size()) - 1))],
                static_cast<std::uint8_t>(upTo(2))};
    }
    for (Course& course : chart.courses) {
        course.colours = upTo(1) == 0 ? ColourMethod::Float : ColourMethod::Intarsia;
        course.rack = beds == BedUse::Double ? upTo(3) : 0;
    }
    return chart;
}

class RandomCharts : public ::testing::TestWithParam<BedUse> {};

INSTANTIATE_TEST_SUITE_P(Beds, RandomCharts, ::testing::Values(BedUse::Single, BedUse::Double),
                         [](const auto& info) { return info.param == BedUse::Single ? "Single" : "Double"; });

TEST_P(RandomCharts, KnitOnTheMachineWithoutAProblem) {
    std::mt19937 random(1998);
    for (int i = 0; i < 300; ++i) {
        const Chart chart = randomChart(random, GetParam());
        const CastOn castOn = i % 2 == 0 ? CastOn::Open : CastOn::Alternating;
        const Program program = compiled(chart, {.castOn = castOn});
        const Timeline timeline = knitted(program);
        for (const machine::CarrierState& carrier : timeline.finalState().carriers) {
            EXPECT_FALSE(carrier.in);
        }
        // Every loop is held or was drawn through: nothing is lost when loops change beds.
        std::vector<bool> kept(timeline.loops().loops.size(), false);
        for (const LoopIndex parent : timeline.loops().parents) {
            kept[static_cast<std::size_t>(parent)] = true;
        }
        for (const Bed bed : {Bed::Front, Bed::Rear}) {
            for (int needle = 1; needle <= chart.width; ++needle) {
                for (const LoopIndex loop : timeline.finalState().loopsOn({bed, needle})) {
                    kept[static_cast<std::size_t>(loop)] = true;
                }
            }
        }
        EXPECT_EQ(std::ranges::count(kept, false), 0) << "chart " << i;
    }
}

TEST_P(RandomCharts, EveryStitchIsMadeOnItsBedWithItsYarn) {
    std::mt19937 random(2023);
    for (int i = 0; i < 100; ++i) {
        const Chart chart = randomChart(random, GetParam());
        const Program program = compiled(chart);
        for (const Stitch stitch : {Stitch::Knit, Stitch::Purl}) {
            const Bed bed = stitch == Stitch::Knit ? Bed::Front : Bed::Rear;
            for (std::size_t yarn = 0; yarn < chart.yarns.size(); ++yarn) {
                const auto inChart = std::ranges::count_if(chart.cells, [&](const Cell& cell) {
                    return cell.yarn == yarn && (cell.stitch == stitch || cell.stitch == Stitch::Both);
                });
                const auto made = std::ranges::count_if(program.operations, [&](const Operation& op) {
                    return op.kind == machine::OperationKind::Knit && op.needle.bed == bed &&
                           op.carriers[0] == yarn;
                });
                EXPECT_EQ(made, inChart) << "chart " << i;
            }
        }
    }
}

} // namespace
} // namespace knittsim::pattern
