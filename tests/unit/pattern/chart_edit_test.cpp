#include "core/pattern/chart_edit.h"
#include "core/pattern/swatch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace knittsim::pattern {
namespace {

/// Every cell differs from its neighbours; one cable.
Chart patterned(int wales, int courses) {
    Chart chart(wales, courses);
    chart.yarns = {{"1", {}, ""}, {"2", {}, ""}, {"3", {}, ""}};
    for (int c = 0; c < courses; ++c) {
        for (int w = 0; w < wales; ++w) {
            chart.at(w, c) = {(w + 2 * c) % 5 < 2 ? Stitch::Purl : Stitch::Knit,
                              static_cast<std::uint8_t>((w + c) % 3)};
        }
    }
    chart.course(courses / 2).moves = cross(1, 1, 1, Front::Right);
    return chart;
}

TEST(ChartEdit, ALineTouchesBothEndsAndHasNoGaps) {
    for (const CellPlace end : {CellPlace{7, 3}, {3, 7}, {-4, 2}, {0, 0}, {-5, -5}}) {
        const auto line = lineOf({0, 0}, end);
        EXPECT_EQ(line.front(), (CellPlace{0, 0}));
        EXPECT_EQ(line.back(), end);
        for (std::size_t i = 1; i < line.size(); ++i) {
            EXPECT_LE(std::abs(line[i].wale - line[i - 1].wale), 1);
            EXPECT_LE(std::abs(line[i].course - line[i - 1].course), 1);
        }
        EXPECT_EQ(line.size(),
                  static_cast<std::size_t>(std::max(std::abs(end.wale), std::abs(end.course))) + 1);
    }
}

TEST(ChartEdit, ABrushPaintsWhatItHas) {
    Chart chart = patterned(6, 6);
    const Cell before = chart.at(2, 3);
    const CellPlace places[] = {{2, 3}, {-1, 0}, {6, 6}}; // two lie outside
    paint(chart, places, {Stitch::Tuck, std::nullopt});
    EXPECT_EQ(chart.at(2, 3), (Cell{Stitch::Tuck, before.yarn}));
    paint(chart, places, {std::nullopt, std::uint8_t{2}});
    EXPECT_EQ(chart.at(2, 3), (Cell{Stitch::Tuck, 2}));
}

TEST(ChartEdit, FillStopsAtOtherCells) {
    Chart chart = plainChart(9, 9);
    paintRange(chart, {2, 2, 5, 5}, {Stitch::Purl, std::nullopt}, true);
    fill(chart, {4, 4}, {Stitch::Tuck, std::nullopt});
    int tucks = 0;
    for (const Cell& cell : chart.cells) {
        tucks += cell.stitch == Stitch::Tuck ? 1 : 0;
    }
    EXPECT_EQ(tucks, 9);
    EXPECT_EQ(chart.at(2, 2).stitch, Stitch::Purl);
    EXPECT_EQ(chart.at(0, 0).stitch, Stitch::Knit);
}

TEST(ChartEdit, FillOfALargeChartReachesEveryCell) {
    Chart chart = plainChart(500, 500);
    fill(chart, {250, 250}, {Stitch::Purl, std::nullopt});
    EXPECT_TRUE(std::ranges::all_of(chart.cells, [](Cell cell) { return cell.stitch == Stitch::Purl; }));
}

TEST(ChartEdit, WhatIsCopiedAndPastedIsTheSame) {
    const Chart chart = patterned(8, 8);
    Chart other = chart;
    paste(other, {0, 0}, copyOf(chart, {0, 0, 8, 8}));
    EXPECT_EQ(other, chart);
    Chart empty = plainChart(8, 8);
    empty.yarns = chart.yarns;
    paste(empty, {0, 0}, copyOf(chart, {0, 0, 8, 8}));
    for (int c = 0; c < 8; ++c) {
        EXPECT_EQ(empty.course(c).moves, chart.course(c).moves);
    }
    EXPECT_EQ(empty.cells, chart.cells);
}

TEST(ChartEdit, PastingOverTheEdgeKeepsWhatFits) {
    Chart chart = plainChart(5, 5);
    const Chart part = copyOf(patterned(4, 4), {0, 0, 4, 4});
    paste(chart, {3, 3}, part, PasteWhat::Stitches);
    paste(chart, {-3, -3}, part, PasteWhat::Stitches);
    EXPECT_EQ(chart.width, 5);
    EXPECT_EQ(chart.at(4, 4).stitch, part.at(1, 1).stitch);
    EXPECT_EQ(chart.at(0, 0).stitch, part.at(3, 3).stitch);
    EXPECT_TRUE(check(chart).empty());
}

TEST(ChartEdit, TwoMirrorsFourTurnsAndAFullShiftChangeNothing) {
    const Chart chart = patterned(8, 8);
    Chart turned = chart;
    mirror(turned, {0, 0, 8, 8}, Mirror::LeftRight);
    EXPECT_NE(turned, chart);
    mirror(turned, {0, 0, 8, 8}, Mirror::LeftRight);
    EXPECT_EQ(turned, chart);
    mirror(turned, {0, 0, 8, 8}, Mirror::UpDown);
    mirror(turned, {0, 0, 8, 8}, Mirror::UpDown);
    EXPECT_EQ(turned, chart);
    for (int i = 0; i < 4; ++i) {
        EXPECT_TRUE(rotate(turned, {1, 1, 5, 5}));
    }
    EXPECT_EQ(turned.cells, chart.cells);
    EXPECT_FALSE(rotate(turned, {0, 0, 3, 4}));
    shift(turned, {0, 0, 8, 8}, 3, -2);
    shift(turned, {0, 0, 8, 8}, 5, 10);
    EXPECT_EQ(turned.cells, chart.cells);
}

TEST(ChartEdit, AMirroredCableCrossesTheOtherWay) {
    Chart chart(4, 1);
    chart.course(0).moves = cross(0, 2, 2, Front::Right);
    mirror(chart, {0, 0, 4, 1}, Mirror::LeftRight);
    const auto moves = chart.course(0).moves;
    // The loops in front, which are listed first, now go to the right.
    ASSERT_EQ(moves.size(), 4U);
    EXPECT_GT(moves[0].to, moves[0].from);
    EXPECT_GT(moves[1].to, moves[1].from);
}

TEST(ChartEdit, InsertedWalesAndCoursesGoAgain) {
    const Chart chart = patterned(8, 8);
    Chart other = chart;
    insertWales(other, 6, 3);
    insertCourses(other, 2, 4);
    EXPECT_EQ(other.width, 11);
    EXPECT_EQ(other.height(), 12);
    EXPECT_TRUE(check(other).empty());
    removeCourses(other, 2, 4);
    removeWales(other, 6, 3);
    EXPECT_EQ(other, chart);
    removeWales(other, 0, 100);
    removeCourses(other, 0, 100);
    EXPECT_EQ(other.width, 1);
    EXPECT_EQ(other.height(), 1);
}

TEST(ChartEdit, APatchGoesThereAndBack) {
    std::mt19937 random(3);
    Chart chart = patterned(20, 30);
    for (int i = 0; i < 200; ++i) {
        Chart after = chart;
        const CellRange range{static_cast<int>(random() % 20), static_cast<int>(random() % 30), 5, 4};
        switch (random() % 6) {
        case 0:
            paintRange(after, range, {Stitch::Tuck, std::uint8_t{1}});
            break;
        case 1:
            insertCourses(after, range.course, 2);
            break;
        case 2:
            removeCourses(after, range.course, 2);
            break;
        case 3:
            insertWales(after, range.wale, 1);
            break;
        case 4:
            removeWales(after, range.wale, 1);
            break;
        default:
            mirror(after, range, Mirror::LeftRight);
        }
        const ChartPatch patch(chart, after);
        Chart there = chart;
        patch.apply(there);
        ASSERT_EQ(there, after);
        patch.revert(there);
        ASSERT_EQ(there, chart);
        ASSERT_EQ(patch.empty(), chart == after);
        chart = after;
        ASSERT_TRUE(check(chart).empty());
    }
}

TEST(ChartEdit, BindingOffLeavesOneLoopAndLoosesNone) {
    Chart chart = plainChart(5, 3);
    ASSERT_TRUE(bindOff(chart));
    EXPECT_EQ(chart.height(), 3 + 4);
    EXPECT_EQ(chart.course(3).moves, (std::vector<LoopMove>{{4, 3}}));
    EXPECT_EQ(chart.at(0, 6).stitch, Stitch::Knit);
    EXPECT_EQ(chart.at(1, 6).stitch, Stitch::Empty);
    EXPECT_TRUE(check(chart).empty());
    Chart tube = plainChart(5, 3);
    tube.beds = BedUse::Double;
    EXPECT_FALSE(bindOff(tube));
}

TEST(ChartEdit, ABedLessKeepsWhatTheFrontShows) {
    Chart chart(kStitches, 1);
    chart.beds = BedUse::Double;
    for (int w = 0; w < kStitches; ++w) {
        chart.at(w, 0).stitch = static_cast<Stitch>(w);
    }
    chart.course(0).colours = ColourMethod::LadderBack;
    chart.course(0).rack = 1;
    ASSERT_TRUE(useBeds(chart, BedUse::Single));
    chart.yarns = {{"1", {}, ""}};
    EXPECT_TRUE(check(chart).empty());
    EXPECT_EQ(chart.at(static_cast<int>(Stitch::KnitTuck), 0).stitch, Stitch::Knit);
    EXPECT_EQ(chart.course(0).colours, ColourMethod::Float);
}

TEST(ChartEdit, MovedLoopsKeepAChartOnOneBed) {
    Chart chart = plainChart(4, 3);
    chart.course(1).moves = {{1, 2}};
    const Chart before = chart;
    EXPECT_FALSE(useBeds(chart, BedUse::Double));
    EXPECT_EQ(chart, before);
}

} // namespace
} // namespace knittsim::pattern
