#include "core/yarn/count.h"
#include "core/yarn/yarn_library.h"

#include <gtest/gtest.h>

namespace knittsim::yarn {
namespace {

TEST(Count, AgreesWithTheDefinitions) {
    EXPECT_DOUBLE_EQ(texOf(CountSystem::Nm, 15), 1000.0 / 15);
    EXPECT_DOUBLE_EQ(texOf(CountSystem::Den, 9000), 1000); // a gram a metre
    EXPECT_DOUBLE_EQ(texOf(CountSystem::Dtex, 167), 16.7);
    // One hank of 840 yards to the pound: 453.59237 g in 768.096 m.
    EXPECT_NEAR(texOf(CountSystem::Ne, 1), 453.59237 / 0.768096, 0.01);
}

TEST(Count, ThereAndBackIsTheSame) {
    for (const CountSystem system : kCountSystems) {
        EXPECT_NEAR(texOf(system, countOf(system, 66.7)), 66.7, 1e-12) << toString(system);
        EXPECT_EQ(texOf(system, 0), 0);
        EXPECT_EQ(texOf(system, -3), 0);
    }
}

TEST(Count, IsWrittenAsTheTradeDoes) {
    EXPECT_EQ(countText(CountSystem::Nm, 1000.0 / 15), "Nm 15");
    EXPECT_EQ(countText(CountSystem::Den, 7.8), "70.2 den");
}

TEST(Count, TheDiameterHoldsItsFibres) {
    // 1 km of solid wool of 1 mm: pi/4 mm2 x 1 km = 785.4 cm3.
    EXPECT_NEAR(diameterMm(785.398 * 1.31, 1.31, 1), 1, 1e-6);
    EXPECT_NEAR(diameterMm(66.6667, 1.31, 0.5), 0.36, 0.001); // as the library's Merino 2/30
}

} // namespace
} // namespace knittsim::yarn
