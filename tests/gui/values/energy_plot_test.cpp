#include "ui/views/simulation_panel/energy_history.h"
#include "ui/views/simulation_panel/energy_scale.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace knittsim::ui {
namespace {

EnergySample sample(std::int64_t step) {
    return {step, {0, static_cast<double>(step)}, 1};
}

TEST(EnergyHistory, KeepsTheWholeRunInBoundedMemory) {
    EnergyHistory history;
    for (std::int64_t step = 0; step < 100'000; ++step) {
        history.add(sample(step));
        ASSERT_LT(history.samples().size(), EnergyHistory::kCapacity);
        ASSERT_EQ(history.samples().back().step, step) << "the newest is always there";
    }
    EXPECT_EQ(history.samples().front().step, 0) << "and so is the first";
    EXPECT_GT(history.samples().size(), EnergyHistory::kCapacity / 3);
}

TEST(EnergyHistory, StepsRiseAndAreSpreadEvenly) {
    EnergyHistory history;
    for (std::int64_t step = 0; step < 9000; ++step) {
        history.add(sample(step));
    }
    const auto& samples = history.samples();
    std::int64_t widest = 0;
    for (std::size_t i = 1; i < samples.size(); ++i) {
        ASSERT_LT(samples[i - 1].step, samples[i].step);
        widest = std::max(widest, samples[i].step - samples[i - 1].step);
    }
    EXPECT_LE(widest, 2 * 9000 / static_cast<std::int64_t>(samples.size()) + 1);
}

TEST(EnergyHistory, AShortRunIsKeptCompletely) {
    EnergyHistory history;
    for (std::int64_t step = 0; step < 500; ++step) {
        history.add(sample(step));
    }
    EXPECT_EQ(history.samples().size(), 500U);
    history.clear();
    EXPECT_TRUE(history.empty());
}

TEST(SymmetricLogScale, EndsZeroAndSignsAreWhereTheyBelong) {
    const SymmetricLogScale scale(-100, 100);
    EXPECT_DOUBLE_EQ(scale.map(-100), 0);
    EXPECT_DOUBLE_EQ(scale.map(100), 1);
    EXPECT_DOUBLE_EQ(scale.map(0), 0.5);
    // Far from zero a factor of ten takes the same way everywhere.
    EXPECT_NEAR(scale.map(100) - scale.map(10), scale.map(10) - scale.map(1), 1e-3);
}

TEST(SymmetricLogScale, AllZeroIsDrawable) {
    const SymmetricLogScale scale(0, 0);
    EXPECT_DOUBLE_EQ(scale.map(0), 0);
    const std::vector<double> ticks = scale.ticks();
    EXPECT_TRUE(std::is_sorted(ticks.begin(), ticks.end()));
}

TEST(SymmetricLogScale, TicksAreZeroAndPowersOfTenInside) {
    const std::vector<double> ticks = SymmetricLogScale(0, 250, 2).ticks();
    ASSERT_EQ(ticks.size(), 3U);
    EXPECT_DOUBLE_EQ(ticks[0], 0);
    EXPECT_NEAR(ticks[1], 10, 1e-9);
    EXPECT_NEAR(ticks[2], 100, 1e-9);
}

TEST(LogScale, GoesFromWholePowerToWholePower) {
    const LogScale scale(3e-4, 1);
    EXPECT_EQ(scale.firstPower(), -4);
    EXPECT_EQ(scale.lastPower(), 0);
    EXPECT_DOUBLE_EQ(scale.map(1), 1);
    EXPECT_DOUBLE_EQ(scale.map(1e-2), 0.5);
    EXPECT_DOUBLE_EQ(scale.map(0), 0) << "below the axis lies at its foot";
}

} // namespace
} // namespace knittsim::ui
