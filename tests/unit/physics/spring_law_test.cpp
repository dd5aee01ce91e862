#include "core/physics/spring_law.h"

#include <gtest/gtest.h>

#include <cmath>

namespace knittsim::physics {
namespace {

const Spring kSpring{0, 1, 2.0, 3.0, 5.0}; // rest 2, pull 3, push 5

TEST(SpringLaw, EquationEightPullsWithTheFourthPower) {
    const SpringValue value = evaluateSpring({PullLaw::Quartic, 1, {}}, kSpring, 2.5);
    EXPECT_DOUBLE_EQ(value.energy, 3 * std::pow(0.5, 4));
    EXPECT_DOUBLE_EQ(value.force, 12 * std::pow(0.5, 3));
}

TEST(SpringLaw, EquationSevenRepelsWithTheSquare) {
    const SpringValue value = evaluateSpring({PullLaw::Quartic, 1, {}}, kSpring, 1.5);
    EXPECT_DOUBLE_EQ(value.energy, 5 * 0.25);
    EXPECT_DOUBLE_EQ(value.force, -5);
}

TEST(SpringLaw, EquationTwoIsTheForceOfEachExponent) {
    for (const int a : {1, 3, 5}) {
        for (const double distance : {1.25, 2.75}) {
            const SpringValue value = evaluateSpring({PullLaw::Power, a, {}}, kSpring, distance);
            EXPECT_NEAR(value.force, 3 * std::pow(distance - 2, a), 1e-12) << a;
            EXPECT_GE(value.energy, 0);
        }
    }
}

TEST(SpringLaw, ThePreviewIsLinearOnBothSides) {
    EXPECT_DOUBLE_EQ(evaluateSpring({}, kSpring, 3).force, 3);
    EXPECT_DOUBLE_EQ(evaluateSpring({}, kSpring, 1).force, -5);
    EXPECT_DOUBLE_EQ(evaluateSpring({}, Spring{0, 1, 2, 3, 0}, 1).force, 0); // a slack yarn does not push
}

TEST(SpringLaw, ATableGivesItsForcesAndTheWorkBelowThem) {
    const SpringLaw law{PullLaw::Table, 1, {{0, 0.1, 0.5}, {0, 1, 9}}};
    // strain 0.3 of 2 mm: force half way between 1 and 9
    const SpringValue value = evaluateSpring(law, kSpring, 2.6);
    EXPECT_NEAR(value.force, 5, 1e-12);
    EXPECT_NEAR(value.energy, (0.5 * 1 * 0.1 + 0.5 * (1 + 5) * 0.2) * 2, 1e-12);
    EXPECT_NEAR(evaluateSpring(law, kSpring, 3.2).force, 9 + 20 * 0.1, 1e-12); // last slope goes on
}

} // namespace
} // namespace knittsim::physics
