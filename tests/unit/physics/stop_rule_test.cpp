#include "knit.h"

#include <gtest/gtest.h>

#include <limits>

namespace knittsim::physics {
namespace {

using Verdict = StopRule::Verdict;

struct StopRuleTest : ::testing::Test {
    fabric::Fabric f = test::plain(4, 4);
    BondingPointModel net = buildBondingPointModel(f, {});
    Vector start = machinePositions(f);
    StopRule rule;
    double startNorm = 0;

    void SetUp() override {
        rule.setReference(*net.model, start);
        Vector gradient;
        net.model->evaluate(start, &gradient);
        startNorm = gradient.norm();
    }

    static StepReport moved(double potential, double forceNorm, double kinetic = 0) {
        StepReport report;
        report.potential = potential;
        report.forceNorm = forceNorm;
        report.kinetic = kinetic;
        return report;
    }
};

TEST_F(StopRuleTest, ResidualIsRelativeToTheStart) {
    EXPECT_DOUBLE_EQ(rule.residual(startNorm), 1);
}

TEST_F(StopRuleTest, RestsBelowTheLimit) {
    rule.setLimit(1e-2);
    EXPECT_EQ(rule.judge(moved(5, 0.5 * startNorm), start, true), Verdict::GoOn);
    EXPECT_EQ(rule.judge(moved(4, 0.009 * startNorm), start, true), Verdict::ResidualReached);
}

TEST_F(StopRuleTest, PassingTheRestShapeAtSpeedIsNotRest) {
    const double energy = net.model->evaluate(start, nullptr);
    EXPECT_EQ(rule.judge(moved(0, 1e-9 * startNorm, 0.1 * energy), start, false), Verdict::GoOn);
}

TEST_F(StopRuleTest, AStartAtRestRestsAtOnce) {
    const Vector x = test::settle(*net.model, f, "newton-cg", 1e-8).motion.positions;
    rule.setReference(*net.model, x);
    Vector gradient;
    const double energy = net.model->evaluate(x, &gradient);
    EXPECT_EQ(rule.judge(moved(energy, gradient.norm()), x, true), Verdict::ResidualReached);
}

TEST_F(StopRuleTest, TellsUselessNumbers) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(rule.judge(moved(nan, 1), start, true), Verdict::Diverged);
    Vector broken = start;
    broken[4] = std::numeric_limits<double>::infinity();
    EXPECT_EQ(rule.judge(moved(1, startNorm), broken, true), Verdict::Diverged);
}

TEST_F(StopRuleTest, StandingStillIsStagnation) {
    Verdict verdict = Verdict::GoOn;
    int steps = 0;
    while (verdict == Verdict::GoOn && steps < 1000) {
        verdict = rule.judge(moved(7, startNorm), start, true);
        ++steps;
    }
    EXPECT_EQ(verdict, Verdict::Stagnation);
}

TEST_F(StopRuleTest, AMovingShapeEndsAtTheStepLimit) {
    Vector x = start;
    Verdict verdict = Verdict::GoOn;
    double energy = 1e9;
    while (verdict == Verdict::GoOn) {
        x[0] += 0.1;
        verdict = rule.judge(moved(energy *= 0.999, startNorm), x, true);
    }
    EXPECT_EQ(verdict, Verdict::StepLimit);
}

TEST_F(StopRuleTest, StuckTwiceIsStagnationAndFailureIsFailure) {
    StepReport report = moved(5, startNorm);
    report.outcome = StepReport::Outcome::Stuck;
    EXPECT_EQ(rule.judge(report, start, true), Verdict::GoOn);
    EXPECT_EQ(rule.judge(report, start, true), Verdict::Stagnation);
    report.outcome = StepReport::Outcome::Failed;
    EXPECT_EQ(rule.judge(report, start, true), Verdict::SolverFailed);
}

} // namespace
} // namespace knittsim::physics
