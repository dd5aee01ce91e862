#include "tests/support/build.h"
#include "ui/document/selection.h"

#include <gtest/gtest.h>

namespace knittsim::document {
namespace {

// Lines: 1 magic, 2 carriers, 3 in, 4 and 5 knit, 6 rack, 7 plated knit.
class SelectionTest : public ::testing::Test {
protected:
    machine::Timeline timeline = test::timeline("in 1 2\nknit - f2 1\nknit - f1 1\nrack 1\nknit + f1 1 2\n");
    const machine::Program& program = timeline.program();
    const machine::LoopTable& loops = timeline.loops();
};

TEST_F(SelectionTest, LoopOperationAndLineAreOneThing) {
    const Selection byLoop = selectionOfLoop(program, loops, 1);
    EXPECT_EQ(byLoop, (Selection{1, 2, 5}));
    EXPECT_EQ(selectionOfOperation(program, loops, 2), byLoop);
    EXPECT_EQ(selectionOfLine(program, loops, 5), byLoop);
}

TEST_F(SelectionTest, AnOperationWithoutStitchHasNoLoop) {
    EXPECT_EQ(selectionOfLine(program, loops, 6), (Selection{-1, 3, 6}));
}

TEST_F(SelectionTest, TheSecondLoopOfAPlatedStitchStaysSelected) {
    EXPECT_EQ(selectionOfOperation(program, loops, 4).loop, 2);
    EXPECT_EQ(selectionOfLoop(program, loops, 3), (Selection{3, 4, 7}));
}

TEST_F(SelectionTest, ALineWithoutOperationSelectsOnlyTheLine) {
    EXPECT_EQ(selectionOfLine(program, loops, 1), (Selection{-1, -1, 1}));
}

TEST_F(SelectionTest, NothingOutsideTheProgramIsSelected) {
    EXPECT_TRUE(selectionOfLoop(program, loops, -1).empty());
    EXPECT_TRUE(selectionOfLoop(program, loops, 99).empty());
    EXPECT_TRUE(selectionOfOperation(program, loops, 99).empty());
}

} // namespace
} // namespace knittsim::document
