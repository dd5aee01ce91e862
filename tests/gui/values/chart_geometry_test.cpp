#include "ui/views/pattern_editor/chart_geometry.h"

#include <gtest/gtest.h>

namespace knittsim::ui {
namespace {

ChartGeometry chart(int columns, int courses, int cell) {
    ChartGeometry geometry;
    geometry.columns = columns;
    geometry.courses = courses;
    geometry.cellWidth = cell;
    geometry.view = {400, 300};
    geometry.header = {30, 20};
    return geometry;
}

TEST(ChartGeometry, TheMiddleOfEveryCellLeadsBackToTheCell) {
    for (const int cell : {2, 3, 9, 24, 64}) {
        ChartGeometry geometry = chart(500, 400, cell);
        geometry.scroll = {geometry.content().width() / 2, geometry.content().height() / 2};
        const auto columns = geometry.visibleColumns();
        const auto courses = geometry.visibleCourses();
        int seen = 0;
        for (std::int32_t course = courses.first; course < courses.end; ++course) {
            for (std::int32_t column = columns.first; column < columns.end; ++column) {
                const QPoint middle = geometry.cellRect(course, column).center();
                if (geometry.chartArea().contains(middle)) {
                    const auto found = geometry.cellAt(middle);
                    ASSERT_EQ(found.course, course);
                    ASSERT_EQ(found.column, column);
                    ++seen;
                }
            }
        }
        EXPECT_GT(seen, 10) << "cell " << cell;
    }
}

TEST(ChartGeometry, CourseZeroIsAtTheBottom) {
    const ChartGeometry geometry = chart(4, 3, 20);
    EXPECT_GT(geometry.cellRect(0, 0).top(), geometry.cellRect(2, 0).top());
    EXPECT_LT(geometry.cellRect(0, 0).left(), geometry.cellRect(0, 3).left());
}

TEST(ChartGeometry, ASmallChartStandsInTheMiddle) {
    const ChartGeometry geometry = chart(4, 3, 20);
    const QRect whole = geometry.cellRect(2, 0).united(geometry.cellRect(0, 3));
    EXPECT_NEAR(whole.center().x(), geometry.chartArea().center().x(), 1);
    EXPECT_NEAR(whole.center().y(), geometry.chartArea().center().y(), 1);
}

TEST(ChartGeometry, HeadersAndTheOutsideAreNoCells) {
    const ChartGeometry geometry = chart(100, 100, 20);
    EXPECT_EQ(geometry.cellAt({5, 50}).course, -1);
    EXPECT_EQ(geometry.cellAt({200, 295}).course, -1);
    EXPECT_EQ(chart(4, 3, 20).cellAt({35, 5}).course, -1);
}

TEST(ChartGeometry, OnlyVisibleCellsAreListed) {
    ChartGeometry geometry = chart(500, 500, 10);
    geometry.scroll = {1000, 1200};
    const auto columns = geometry.visibleColumns();
    EXPECT_EQ(columns.first, 100);
    EXPECT_LE(columns.end - columns.first, 370 / 10 + 1);
    const auto courses = geometry.visibleCourses();
    EXPECT_LE(courses.end - courses.first, 280 / geometry.cellHeight() + 2);
}

TEST(ChartGeometry, FittingTakesTheLargestCellThatShowsAll) {
    const ChartGeometry geometry = chart(37, 10, 10);
    EXPECT_EQ(geometry.fittingCell(4, 40), 10);
    EXPECT_EQ(chart(3, 2, 10).fittingCell(4, 26), 26);
    EXPECT_EQ(chart(3000, 2, 10).fittingCell(4, 26), 4);
}

TEST(ChartGeometry, ZoomLevelsGoUpAndDownTheSameWay) {
    for (int width = ChartGeometry::kMinCell; width < ChartGeometry::kMaxCell;
         width = nextCellWidth(width, +1)) {
        EXPECT_EQ(nextCellWidth(nextCellWidth(width, +1), -1), width);
    }
    EXPECT_EQ(nextCellWidth(ChartGeometry::kMaxCell, +1), ChartGeometry::kMaxCell);
    EXPECT_EQ(nextCellWidth(ChartGeometry::kMinCell, -1), ChartGeometry::kMinCell);
}

} // namespace
} // namespace knittsim::ui
