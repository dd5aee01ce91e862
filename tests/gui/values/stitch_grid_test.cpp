#include "tests/support/build.h"
#include "ui/document/stitch_grid.h"

#include <gtest/gtest.h>

namespace knittsim::document {
namespace {

using test::pass;

struct Made {
    explicit Made(const std::string& lines)
        : timeline(test::timeline(lines)), fabric(fabric::buildFabric(timeline)),
          grid(timeline.loops(), fabric) {}

    const GridCell& cell(int course, int column) const {
        const GridCell* found = grid.cellAt(course, column);
        if (!found) {
            throw std::runtime_error("no cell");
        }
        return *found;
    }
    StitchMark front(int course, int column) const { return grid.markOf(cell(course, column).front); }
    StitchMark rear(int course, int column) const { return grid.markOf(cell(course, column).rear); }

    machine::Timeline timeline;
    fabric::Fabric fabric;
    StitchGrid grid;
};

TEST(StitchGrid, ThreePlainCoursesStandAboveEachOther) {
    const Made made("in 1\n" + pass("knit", 'f', 4, 1, 1) + pass("knit", 'f', 1, 4, 1) +
                    pass("knit", 'f', 4, 1, 1));
    EXPECT_EQ(made.grid.courseCount(), 3);
    EXPECT_EQ(made.grid.firstColumn(), 1);
    EXPECT_EQ(made.grid.columnCount(), 4);
    EXPECT_EQ(made.grid.loopCount(), 12U);
    EXPECT_EQ(made.front(0, 2).kind, StitchKind::CastOn);
    EXPECT_EQ(made.front(1, 2).kind, StitchKind::Knit);
    EXPECT_EQ(made.front(1, 2).parents, 1);
    EXPECT_EQ(made.cell(2, 3).rear, -1);
    EXPECT_EQ(made.grid.placeOf(0), (GridPlace{0, 4, false}));
}

TEST(StitchGrid, LoopsOfBothBedsShareACell) {
    const Made made("in 1\nrack 0.25\nknit + f1 1\nknit + b1 1\nknit + f2 1\nknit + b2 1\n");
    EXPECT_EQ(made.grid.courseCount(), 1);
    EXPECT_EQ(made.grid.columnCount(), 2);
    EXPECT_GE(made.cell(0, 1).front, 0);
    EXPECT_GE(made.cell(0, 1).rear, 0);
    EXPECT_TRUE(made.rear(0, 1).rear);
    EXPECT_FALSE(made.front(0, 1).rear);
    EXPECT_TRUE(made.grid.usesBothBeds());
    EXPECT_FALSE(Made("in 1\nknit + f1 1\nknit + b2 1\n").grid.usesBothBeds());
}

TEST(StitchGrid, ATransferToTheSideIsToldByTheLoopThatMoved) {
    const Made made("in 1\n" + pass("knit", 'f', 4, 1, 1) + "xfer f2 b2\nrack 1\nxfer b2 f3\nrack 0\n" +
                    "knit + f1 1\nknit + f3 1\nknit + f4 1\n");
    EXPECT_EQ(made.front(0, 2).moved, 1);
    EXPECT_FALSE(made.front(0, 2).otherBed);
    EXPECT_EQ(made.front(0, 1).moved, 0);
    EXPECT_EQ(made.front(1, 3).parents, 2) << "the stitch through the stacked loops";
    EXPECT_EQ(made.grid.cellAt(1, 2), nullptr);
    ASSERT_NE(made.grid.floatAt(1, 2), nullptr) << "the yarn floats past the empty needle";
    EXPECT_EQ(made.grid.floatAt(1, 3), nullptr);
}

TEST(StitchGrid, ATransferToTheOtherBedChangesTheSideOfTheNextStitch) {
    const Made made("in 1\nknit - f1 1\nxfer f1 b1\nknit + b1 1\n");
    EXPECT_TRUE(made.front(0, 1).otherBed);
    EXPECT_TRUE(made.rear(1, 1).rear);
}

TEST(StitchGrid, TucksAndSplitsKeepTheirKind) {
    const Made made("in 1\nknit - f2 1\nknit - f1 1\ntuck + f1 1\nsplit + f2 b2 1\n");
    int tucks = 0;
    int splits = 0;
    for (int loop = 0; loop < 4; ++loop) {
        tucks += made.grid.markOf(loop).kind == StitchKind::Tuck ? 1 : 0;
        splits += made.grid.markOf(loop).kind == StitchKind::Split ? 1 : 0;
    }
    EXPECT_EQ(tucks, 1);
    EXPECT_EQ(splits, 1);
}

TEST(StitchGrid, TwoYarnsOnOneNeedleCountAsTwoLoopsOfOneCell) {
    const Made made("in 1 2\nknit + f1 1 2\n");
    EXPECT_EQ(made.cell(0, 1).frontCount, 2);
    EXPECT_EQ(made.grid.row(0).size(), 1U);
}

TEST(StitchGrid, EveryLoopIsFoundWhereItsPlaceSays) {
    const Made made("in 1\n" + pass("knit", 'f', 9, 0, 1, 3) + pass("knit", 'b', 0, 9, 1) +
                    pass("knit", 'f', 9, 0, 1));
    for (std::size_t i = 0; i < made.grid.loopCount(); ++i) {
        const GridPlace place = made.grid.placeOf(static_cast<LoopIndex>(i));
        const GridCell* cell = made.grid.cellAt(place.course, place.column);
        ASSERT_NE(cell, nullptr);
        EXPECT_EQ(place.rear ? cell->rear : cell->front, static_cast<LoopIndex>(i));
    }
}

TEST(StitchGrid, FarApartNeedlesCostNoMemoryForTheGapBetween) {
    const Made made("in 1\nknit + f0 1\nknit + f3000 1\nknit - f3000 1\nknit - f0 1\n");
    EXPECT_EQ(made.grid.columnCount(), 3001);
    EXPECT_EQ(made.grid.row(0).size(), 2U);
    EXPECT_EQ(made.grid.floats(0).size(), 1U);
}

TEST(StitchGrid, AnEmptyProgramHasNoCourses) {
    const Made made("in 1\n");
    EXPECT_EQ(made.grid.courseCount(), 0);
    EXPECT_TRUE(made.grid.row(0).empty());
    EXPECT_EQ(made.grid.cellAt(-1, 0), nullptr);
}

TEST(ColumnOf, QuarterPitchesStayAndWholePitchesMove) {
    using machine::Bed;
    EXPECT_EQ(columnOf({Bed::Front, 7}, 3), 7);
    EXPECT_EQ(columnOf({Bed::Rear, 7}, 0.25), 7);
    EXPECT_EQ(columnOf({Bed::Rear, 7}, -0.25), 7);
    EXPECT_EQ(columnOf({Bed::Rear, 7}, 0.5), 7);
    EXPECT_EQ(columnOf({Bed::Rear, 7}, 2), 9);
    EXPECT_EQ(columnOf({Bed::Rear, 7}, -1), 6);
}

} // namespace
} // namespace knittsim::document
