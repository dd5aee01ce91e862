#include "core/fabric/reduction.h"
#include "swatches.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <limits>

namespace knittsim::simulation {
namespace {

using test::coordinate;
using test::load;
using test::plain;

/// A loaded simulation of a plain swatch.
Simulation loaded(std::shared_ptr<const fabric::Fabric> fabric = plain()) {
    Simulation simulation;
    simulation.apply(load(std::move(fabric)));
    return simulation;
}

TEST(Simulation, StartsEmptyAndIgnoresWhatItCannotDo) {
    Simulation simulation;
    simulation.apply(command::Start{});
    simulation.apply(command::Step{});
    simulation.apply(command::Pin{3, true});
    simulation.apply(command::Drag{3, 0, 0, 0});
    simulation.apply(command::Release{});
    EXPECT_FALSE(simulation.advance(1));
    EXPECT_EQ(simulation.state(), State::Empty);
    EXPECT_TRUE(simulation.frame().positions.empty());
}

TEST(Simulation, LoadShowsTheMachinesPositions) {
    const auto fabric = plain();
    const Frame frame = loaded(fabric).frame();
    EXPECT_EQ(frame.state, State::Ready);
    EXPECT_EQ(frame.generation, 1U);
    ASSERT_EQ(frame.positions.size(), 3 * fabric->machinePositions.size());
    for (std::size_t e = 0; e < fabric->machinePositions.size(); ++e) {
        EXPECT_FLOAT_EQ(frame.positions[3 * e], static_cast<float>(fabric->machinePositions[e].x()));
    }
    EXPECT_EQ(frame.tension.size(), fabric->points.size());
    EXPECT_DOUBLE_EQ(frame.residual, 1);
    EXPECT_GT(frame.energies.potential, 0);
}

TEST(Simulation, AnotherFabricGoesOnFromTheShape) {
    Simulation simulation = loaded(plain(6, 6));
    simulation.runToEnd(60);
    const Frame before = simulation.frame();
    const auto whole = plain(6, 6);
    const auto reduced = fabric::removeRuns(*whole, {.steps = {{33}}});
    const auto next = std::make_shared<fabric::Fabric>(reduced.fabric);
    simulation.apply(
        command::Replace{.fabric = next,
                         .positions = fabric::pickPositions(reduced.entryBefore, before.positions),
                         .generation = 2});
    const Frame after = simulation.frame();
    EXPECT_EQ(after.state, State::Running) << "one at rest moves again";
    EXPECT_EQ(after.generation, 2U);
    EXPECT_EQ(after.step, before.step);
    ASSERT_EQ(after.positions.size(), 3 * static_cast<std::size_t>(next->entryCount));
    EXPECT_EQ(after.tension.size(), next->points.size());
    for (std::size_t e = 0; e < reduced.entryBefore.size(); ++e) {
        ASSERT_EQ(coordinate(after, static_cast<fabric::EntryIndex>(e), 0),
                  coordinate(before, reduced.entryBefore[e], 0));
    }
    simulation.runToEnd(60);
    EXPECT_EQ(simulation.state(), State::AtRest);
    EXPECT_GT(simulation.frame().step, before.step);
}

TEST(Simulation, APausedOneStaysPausedWithAnotherFabric) {
    Simulation simulation = loaded(plain(6, 6));
    simulation.apply(command::Step{});
    simulation.advance(0);
    ASSERT_EQ(simulation.state(), State::Paused);
    simulation.apply(command::Replace{.fabric = plain(5, 5), .generation = 2});
    EXPECT_EQ(simulation.state(), State::Paused);
    EXPECT_EQ(simulation.frame().positions.size(), 3 * plain(5, 5)->machinePositions.size());
}

TEST(Simulation, NothingLeftOfAFabricIsAtRest) {
    const auto whole = plain(6, 6);
    Simulation simulation = loaded(whole);
    simulation.runToEnd(60);
    const auto runs = fabric::findRuns(*whole, {.stitchHolder = false});
    simulation.apply(
        command::Replace{.fabric = std::make_shared<fabric::Fabric>(fabric::removeRuns(*whole, runs).fabric),
                         .generation = 2});
    simulation.runToEnd(60);
    EXPECT_EQ(simulation.state(), State::AtRest);
    EXPECT_TRUE(simulation.frame().positions.empty());
}

TEST(Simulation, SettlesByItselfAndSaysWhy) {
    Simulation simulation = loaded();
    const double start = simulation.frame().energies.potential;
    simulation.runToEnd(60);
    const Frame frame = simulation.frame();
    EXPECT_EQ(frame.state, State::AtRest);
    EXPECT_EQ(frame.reason, StopReason::ResidualReached);
    EXPECT_LE(frame.residual, 1e-3);
    EXPECT_LT(frame.energies.potential, 1e-3 * start);
    EXPECT_EQ(frame.energies.kinetic, 0);
    EXPECT_EQ(frame.integrator, integrators().front().id);
}

TEST(Simulation, ASmallerLimitGoesOnFromRest) {
    Simulation simulation = loaded();
    simulation.runToEnd(60);
    simulation.apply(command::SetResidual{1e-6});
    EXPECT_EQ(simulation.state(), State::Running);
    simulation.runToEnd(60);
    EXPECT_EQ(simulation.state(), State::AtRest);
    EXPECT_LE(simulation.frame().residual, 1e-6);
}

TEST(Simulation, StepTakesOneStepAndPauses) {
    Simulation simulation = loaded();
    simulation.apply(command::Step{});
    simulation.advance(1000);
    const Frame frame = simulation.frame();
    EXPECT_EQ(frame.step, 1);
    EXPECT_EQ(frame.state, State::Paused);
    EXPECT_EQ(frame.reason, StopReason::Paused);
}

TEST(Simulation, PauseKeepsAndStopForgetsTheVelocity) {
    Simulation simulation = loaded();
    simulation.apply(command::SetIntegrator{"cash-karp"});
    simulation.apply(command::Start{});
    for (int i = 0; i < 20; ++i) {
        simulation.advance(0);
    }
    simulation.apply(command::Pause{});
    const Frame paused = simulation.frame();
    EXPECT_EQ(paused.state, State::Paused);
    EXPECT_GT(paused.energies.kinetic, 0);
    EXPECT_GT(paused.stepSize, 0);
    EXPECT_GT(paused.time, 0);
    simulation.apply(command::Stop{});
    const Frame stopped = simulation.frame();
    EXPECT_EQ(stopped.reason, StopReason::Stopped);
    EXPECT_EQ(stopped.energies.kinetic, 0);
    EXPECT_EQ(stopped.positions, paused.positions);
}

TEST(Simulation, RestartGoesBackToTheMachine) {
    Simulation simulation = loaded();
    const Frame first = simulation.frame();
    simulation.runToEnd(60);
    simulation.apply(command::Restart{7});
    const Frame frame = simulation.frame();
    EXPECT_EQ(frame.state, State::Ready);
    EXPECT_EQ(frame.generation, 7U);
    EXPECT_EQ(frame.step, 0);
    EXPECT_EQ(frame.positions, first.positions);
}

TEST(Simulation, SameCommandsGiveSameNumbers) {
    const auto fabric = plain(8, 8);
    const auto run = [&] {
        Simulation simulation = loaded(fabric);
        simulation.apply(command::Start{});
        simulation.advance(0);
        simulation.apply(command::Drag{10, 20, 5, 3});
        simulation.advance(0);
        simulation.apply(command::SetIntegrator{"fire"});
        simulation.apply(command::Pin{4, true});
        for (int i = 0; i < 30; ++i) {
            simulation.advance(0);
        }
        simulation.apply(command::Release{});
        simulation.runToEnd(60);
        return simulation.frame();
    };
    const Frame once = run();
    const Frame again = run();
    EXPECT_EQ(once.step, again.step);
    EXPECT_EQ(once.positions, again.positions);
    EXPECT_EQ(once.tension, again.tension);
}

TEST(Simulation, IntegratorsChangeWhileItRuns) {
    Simulation simulation = loaded(plain(6, 6));
    simulation.apply(command::Start{});
    for (const IntegratorInfo& info : integrators()) {
        simulation.apply(command::SetIntegrator{info.id});
        simulation.advance(0);
        EXPECT_EQ(simulation.frame().integrator, info.id);
        EXPECT_NE(simulation.state(), State::Failed) << info.id;
    }
    simulation.apply(command::SetIntegrator{"no such thing"});
    EXPECT_EQ(simulation.frame().integrator, integrators().back().id);
}

TEST(Simulation, AnotherYarnGoesOnFromThePresentShape) {
    Simulation simulation = loaded();
    simulation.runToEnd(60);
    simulation.apply(command::Drag{0, -20, 0, 0});
    simulation.runToEnd(60);
    const Frame before = simulation.frame();
    yarn::Yarn stiff;
    stiff.bendingStiffness *= 5;
    simulation.apply(command::SetYarn{0, stiff});
    const Frame after = simulation.frame();
    EXPECT_EQ(after.positions, before.positions);
    EXPECT_EQ(after.generation, before.generation);
    EXPECT_EQ(after.state, State::Running);
    EXPECT_GT(after.energies.potential, 1.5 * before.energies.potential);
}

TEST(Simulation, DragPullsAndReleaseLetsGoBack) {
    Simulation simulation = loaded();
    simulation.apply(command::SetResidual{1e-5});
    simulation.apply(command::Pin{0, true});
    simulation.runToEnd(60);
    const Frame rest = simulation.frame();
    const auto entry = static_cast<fabric::EntryIndex>(rest.positions.size() / 3 - 1);
    const float x = test::coordinate(rest, entry, 0);
    simulation.apply(
        command::Drag{entry, x + 5.0, test::coordinate(rest, entry, 1), test::coordinate(rest, entry, 2)});
    EXPECT_EQ(simulation.state(), State::Running);
    simulation.runToEnd(60);
    const Frame pulled = simulation.frame();
    EXPECT_GT(test::coordinate(pulled, entry, 0), x + 1);
    EXPECT_GT(pulled.energies.potential, rest.energies.potential);
    simulation.apply(command::Release{});
    simulation.runToEnd(60);
    // The swatch may have turned about its pin; its shape is the old one.
    const Frame released = simulation.frame();
    EXPECT_NEAR(released.energies.potential, rest.energies.potential, 0.01 * pulled.energies.potential);
    EXPECT_NEAR(test::distance(released, 0, entry), test::distance(rest, 0, entry),
                0.01 * test::distance(rest, 0, entry));
    EXPECT_GT(test::distance(pulled, 0, entry), 1.05F * test::distance(rest, 0, entry));
}

TEST(Simulation, PinsHoldUntilTheyAreFreed) {
    Simulation simulation = loaded();
    const Frame start = simulation.frame();
    const auto last = static_cast<fabric::EntryIndex>(start.positions.size() / 3 - 1);
    simulation.apply(command::Pin{0, true});
    simulation.apply(command::Pin{last, true});
    simulation.runToEnd(60);
    const Frame held = simulation.frame();
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_EQ(test::coordinate(held, 0, axis), test::coordinate(start, 0, axis));
        EXPECT_EQ(test::coordinate(held, last, axis), test::coordinate(start, last, axis));
    }
    simulation.apply(command::Pin{last, false});
    simulation.runToEnd(60);
    EXPECT_LT(simulation.frame().energies.potential, 0.1 * held.energies.potential);
}

TEST(Simulation, StartsFromGivenPositions) {
    const auto fabric = plain();
    Simulation simulation = loaded(fabric);
    simulation.runToEnd(60);
    command::Load again = load(fabric, 2);
    again.positions = simulation.frame().positions;
    simulation.apply(again);
    EXPECT_EQ(simulation.frame().positions, again.positions);
    EXPECT_LT(simulation.frame().residual,
              2e-3); // measured against the machine's positions, not against rest
    again.positions[5] = std::numeric_limits<float>::quiet_NaN();
    simulation.apply(again);
    EXPECT_TRUE(std::isfinite(simulation.frame().positions[5]));
}

TEST(Simulation, AnEmptyFabricRestsAtOnce) {
    Simulation simulation = loaded(std::make_shared<fabric::Fabric>());
    simulation.runToEnd(5);
    EXPECT_EQ(simulation.state(), State::AtRest);
}

TEST(Simulation, ACancelStopsInsideAStepWithoutATrace) {
    Simulation simulation = loaded(plain(40, 40));
    simulation.apply(command::Start{});
    int questions = 0;
    const std::function<bool()> cancelled = [&] { return ++questions > 6; };
    const Frame before = simulation.frame();
    simulation.advance(1000, &cancelled);
    EXPECT_EQ(simulation.state(), State::Running);
    EXPECT_EQ(simulation.frame().positions, before.positions);
    simulation.runToEnd(60);
    EXPECT_EQ(simulation.state(), State::AtRest);
}

TEST(Simulation, UselessNumbersLeaveTheLastGoodShape) {
    Simulation simulation = loaded();
    simulation.apply(command::Start{});
    simulation.advance(0);
    const Frame good = simulation.frame();
    yarn::Yarn broken;
    broken.bendingStiffness = std::numeric_limits<double>::quiet_NaN();
    simulation.apply(command::SetYarn{0, broken});
    simulation.runToEnd(10);
    const Frame frame = simulation.frame();
    EXPECT_EQ(frame.state, State::Failed);
    EXPECT_EQ(frame.positions, good.positions);
}

} // namespace
} // namespace knittsim::simulation
