#include "tests/support/build.h"

#include <gtest/gtest.h>

namespace knittsim::machine {
namespace {

using test::pass;

TEST(Passes, ATurnBeginsANewPass) {
    const auto passes =
        findPasses(test::program("in 1\n" + pass("knit", 'f', 0, 3, 1) + pass("knit", 'f', 3, 0, 1)));
    ASSERT_EQ(passes.size(), 2U);
    EXPECT_EQ(passes[0].first, 1);
    EXPECT_EQ(passes[0].count, 4);
    EXPECT_EQ(passes[1].direction, Direction::Left);
}

TEST(Passes, BothBedsOfARibAreOnePass) {
    EXPECT_EQ(findPasses(test::program("in 1\nknit + f0 1\nknit + b1 1\nknit + f2 1\n")).size(), 1U);
}

TEST(Passes, ATransferEndsAPass) {
    EXPECT_EQ(findPasses(test::program("in 1\nknit + f0 1\nxfer f0 b0\nknit + f1 1\n")).size(), 2U);
}

TEST(Passes, GoingBackInTheSameDirectionIsANewPass) {
    EXPECT_EQ(findPasses(test::program("in 1\nknit + f5 1\nknit + f2 1\n")).size(), 2U);
    EXPECT_EQ(findPasses(test::program("in 1\nknit + f5 1\nknit + f5 1\n")).size(), 2U);
}

TEST(Passes, AnotherCarrierIsANewPass) {
    EXPECT_EQ(findPasses(test::program("in 1\nin 2\nknit + f0 1\nknit + f1 2\n")).size(), 2U);
}

TEST(Passes, ReleasingTheHookDoesNotEndAPass) {
    EXPECT_EQ(findPasses(test::program("inhook 1\nknit + f0 1\nreleasehook 1\nknit + f1 1\n")).size(), 1U);
}

} // namespace
} // namespace knittsim::machine
