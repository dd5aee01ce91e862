#include "core/pattern/backing.h"
#include "knitted.h"

#include <gtest/gtest.h>

#include <set>

namespace knittsim::pattern {
namespace {

/// Digits are yarns, rows from the top.
Chart coloured(const std::vector<std::string>& rows, ColourMethod method) {
    Chart chart(static_cast<int>(rows[0].size()), static_cast<int>(rows.size()));
    chart.beds = BedUse::Double;
    chart.yarns = {{"1", {}, ""}, {"2", {}, ""}, {"3", {}, ""}};
    for (int c = 0; c < chart.height(); ++c) {
        chart.course(c).colours = method;
        for (int w = 0; w < chart.width; ++w) {
            const char digit =
                rows[rows.size() - 1 - static_cast<std::size_t>(c)][static_cast<std::size_t>(w)];
            chart.at(w, c).yarn = static_cast<std::uint8_t>(digit - '0');
        }
    }
    return chart;
}

TEST(Backing, BirdseyeOfTwoColoursWorksEveryRearNeedleOnceAndChangesPlacesEveryCourse) {
    const Chart chart = coloured({"001100", "001100"}, ColourMethod::Birdseye);
    EXPECT_EQ(backingOf(chart, 0, 0), (std::vector{0, 2, 4}));
    EXPECT_EQ(backingOf(chart, 0, 1), (std::vector{1, 3, 5}));
    EXPECT_EQ(backingOf(chart, 1, 0), (std::vector{1, 3, 5}));
    EXPECT_EQ(backingOf(chart, 1, 1), (std::vector{0, 2, 4}));
    EXPECT_TRUE(backingOf(chart, 0, 2).empty());
}

TEST(Backing, LadderKnitsOneYarnThatIsNotShown) {
    const Chart chart = coloured({"0000111122220000"}, ColourMethod::LadderBack);
    std::set<int> wales;
    for (int yarn = 0; yarn < 3; ++yarn) {
        for (const int wale : backingOf(chart, 0, yarn)) {
            EXPECT_NE(chart.at(wale, 0).yarn, yarn);
            EXPECT_TRUE(wales.insert(wale).second) << "knitted twice";
        }
    }
    EXPECT_EQ(wales, (std::set{0, 4, 8, 12}));
}

TEST(Backing, NoFloatOfTwoColoursIsLongerThanALadderStep) {
    const Chart chart = coloured({"0000000011111111"}, ColourMethod::LadderBack);
    for (const int yarn : {0, 1}) {
        std::set<int> worked;
        for (int w = 0; w < chart.width; ++w) {
            if (chart.at(w, 0).yarn == yarn) {
                worked.insert(w);
            }
        }
        const auto back = backingOf(chart, 0, yarn);
        worked.insert(back.begin(), back.end());
        int last = *worked.begin();
        for (const int wale : worked) {
            EXPECT_LE(wale - last, kLadderStep);
            last = wale;
        }
    }
}

TEST(Backing, LeavesOutCellsThatSayWhatTheRearNeedleDoes) {
    Chart chart = coloured({"0101"}, ColourMethod::Birdseye);
    chart.at(0, 0).stitch = Stitch::Both;
    chart.at(2, 0).stitch = Stitch::Empty;
    EXPECT_TRUE(backingOf(chart, 0, 0).empty());
    EXPECT_EQ(backingOf(chart, 0, 1), (std::vector{1, 3}));
}

TEST(Backing, FloatsAndIntarsiaHaveNone) {
    EXPECT_TRUE(backingOf(coloured({"0101"}, ColourMethod::Float), 0, 0).empty());
    EXPECT_TRUE(backingOf(coloured({"0011"}, ColourMethod::Intarsia), 0, 0).empty());
}

TEST(Backing, NeedsTwoBeds) {
    Chart chart = coloured({"0101"}, ColourMethod::Birdseye);
    EXPECT_TRUE(check(chart).empty());
    chart.beds = BedUse::Single;
    ASSERT_EQ(check(chart).size(), 1U);
    EXPECT_EQ(check(chart)[0].id, "KS0504");
}

TEST(Backing, StitchesOfTheBackAreKnittedAtAQuarterRacking) {
    const auto lines = linesOf(compiled(coloured({"01"}, ColourMethod::Birdseye)));
    EXPECT_EQ(lines, (std::vector<std::string>{"rack 0.25", "knit - b1 1", "knit - f1 1", "knit - b2 2",
                                               "knit - f2 2", "rack 0"}));
}

} // namespace
} // namespace knittsim::pattern
