#include "knit.h"

#include <gtest/gtest.h>

#include <cmath>

namespace knittsim::physics {
namespace {

using fabric::Fabric;

class IntegratorTest : public ::testing::TestWithParam<const char*> {};

/// Distances of all springs: the shape without its place in space.
Vector springLengths(const Model& model, const Vector& x) {
    const auto& springs = model.springs().springs();
    Vector result(static_cast<Eigen::Index>(springs.size()));
    for (std::size_t i = 0; i < springs.size(); ++i) {
        result[static_cast<Eigen::Index>(i)] = (at(x, springs[i].b) - at(x, springs[i].a)).norm();
    }
    return result;
}

/// The methods in time come to rest slowly.
double limitFor(std::string_view id) {
    return id == "newton-cg" || id == "kinsol" || id == "fire" || id == "l-bfgs" ? 1e-4 : 1e-3;
}

TEST_P(IntegratorTest, FindsTheRestShapeOfAPlainSwatch) {
    const Fabric f = test::plain(12, 12);
    const BondingPointModel net = buildBondingPointModel(f, {});
    const Vector expected =
        springLengths(*net.model, test::settle(*net.model, f, "newton-cg", 1e-6).motion.positions);
    const auto settled = test::settle(*net.model, f, GetParam(), limitFor(GetParam()));
    EXPECT_EQ(settled.verdict, StopRule::Verdict::ResidualReached);
    const Vector got = springLengths(*net.model, settled.motion.positions);
    double worst = 0;
    for (std::size_t i = 0; i < net.model->springs().springs().size(); ++i) {
        if (net.model->springs().springs()[i].push > 0) { // slack floats may hang as they like
            const auto k = static_cast<Eigen::Index>(i);
            worst = std::max(worst, std::abs(got[k] - expected[k]));
        }
    }
    EXPECT_LT(worst, 0.03 * net.model->lengthScale());
}

TEST_P(IntegratorTest, HoldsPinnedEntriesExactly) {
    const Fabric f = test::plain(5, 5);
    const BondingPointModel net = buildBondingPointModel(f, {});
    net.model->setPinned(0, true);
    net.model->setPinned(17, true);
    const Vector start = machinePositions(f);
    const auto settled = test::settle(*net.model, f, GetParam(), 1e-2);
    EXPECT_EQ((at(settled.motion.positions, 0) - at(start, 0)).norm(), 0);
    EXPECT_EQ((at(settled.motion.positions, 17) - at(start, 17)).norm(), 0);
}

TEST_P(IntegratorTest, GivesTheSameNumbersTwice) {
    const Fabric f = test::rib(6, 5);
    const BondingPointModel net = buildBondingPointModel(f, {});
    const auto once = test::settle(*net.model, f, GetParam(), 1e-2);
    const auto again = test::settle(*net.model, f, GetParam(), 1e-2);
    EXPECT_EQ(once.steps, again.steps);
    EXPECT_EQ(once.motion.positions, again.motion.positions);
}

TEST_P(IntegratorTest, AnInterruptedStepChangesNothing) {
    const Fabric f = test::plain(6, 6);
    const BondingPointModel net = buildBondingPointModel(f, {});
    Motion motion{machinePositions(f), Vector::Zero(net.model->size()), 0};
    const Vector before = motion.positions;
    const auto integrator = makeIntegrator(GetParam());
    integrator->initialise(*net.model, motion);
    const std::function<bool()> always = [] { return true; };
    EXPECT_EQ(integrator->step(motion, Interrupt(&always)).outcome, StepReport::Outcome::Cancelled);
    EXPECT_EQ(motion.positions, before);
    integrator->initialise(*net.model, motion);
    EXPECT_EQ(integrator->step(motion, {}).outcome, StepReport::Outcome::Moved);
}

TEST_P(IntegratorTest, IsAskedOftenWhetherToGoOn) {
    // The number of forces and products between two questions is bounded, so that a cancel is heard in time.
    const Fabric f = test::plain(10, 10);
    const BondingPointModel net = buildBondingPointModel(f, {});
    Motion motion{machinePositions(f), Vector::Zero(net.model->size()), 0};
    const auto integrator = makeIntegrator(GetParam());
    integrator->initialise(*net.model, motion);
    int asked = 0;
    const std::function<bool()> count = [&] {
        ++asked;
        return false;
    };
    int evaluations = 0;
    for (int i = 0; i < 5; ++i) {
        evaluations += integrator->step(motion, Interrupt(&count)).evaluations;
    }
    EXPECT_GE(3 * asked, evaluations - 5);
}

TEST_P(IntegratorTest, HandsItsStateToAnyOther) {
    const Fabric f = test::plain(6, 6);
    const BondingPointModel net = buildBondingPointModel(f, {});
    Motion motion{machinePositions(f), Vector::Zero(net.model->size()), 0};
    for (const IntegratorKind& other : integratorKinds()) {
        for (const char* id : {GetParam(), other.id}) {
            const auto integrator = makeIntegrator(id);
            integrator->initialise(*net.model, motion);
            const StepReport report = integrator->step(motion, {});
            EXPECT_NE(report.outcome, StepReport::Outcome::Failed) << id << ' ' << report.note;
            EXPECT_TRUE(motion.positions.allFinite() && motion.velocities.allFinite());
        }
    }
}

std::vector<const char*> ids() {
    std::vector<const char*> result;
    for (const IntegratorKind& kind : integratorKinds()) {
        result.push_back(kind.id);
    }
    return result;
}

std::string testName(const ::testing::TestParamInfo<const char*>& info) {
    std::string name = info.param;
    std::erase(name, '-');
    return name;
}

INSTANTIATE_TEST_SUITE_P(All, IntegratorTest, ::testing::ValuesIn(ids()), testName);

TEST(Integrators, UnknownNamesGiveNone) {
    EXPECT_EQ(makeIntegrator("euler"), nullptr);
}

TEST(Integrators, NoSpringIsDistortedMoreThanAllowedInALargeStep) {
    const Fabric f = test::rib(8, 8);
    const BondingPointModel net = buildBondingPointModel(f, {});
    Motion motion{machinePositions(f), Vector::Zero(net.model->size()), 0};
    for (const char* id : {"newton-cg", "kinsol"}) {
        motion.positions = machinePositions(f);
        const auto integrator = makeIntegrator(id);
        integrator->initialise(*net.model, motion);
        for (int i = 0; i < 5; ++i) {
            const Vector before = motion.positions;
            integrator->step(motion, {});
            EXPECT_LE(net.model->largestDistortion(before, motion.positions - before),
                      kLargestDistortion + 1e-9);
        }
    }
}

TEST(Integrators, TimeMethodsLoseEnergyByDampingOnly) {
    const Fabric f = test::plain(6, 6);
    const BondingPointModel net = buildBondingPointModel(f, {});
    for (const char* id : {"cash-karp", "dormand-prince"}) {
        Motion motion{machinePositions(f), Vector::Zero(net.model->size()), 0};
        const auto integrator = makeIntegrator(id);
        integrator->initialise(*net.model, motion);
        double total = net.model->evaluate(motion.positions, nullptr);
        for (int i = 0; i < 40; ++i) {
            const StepReport report = integrator->step(motion, {});
            EXPECT_LE(report.kinetic + report.potential, total * (1 + 1e-3)) << id << i;
            EXPECT_GT(report.stepSize, 0);
            total = report.kinetic + report.potential;
        }
    }
}

} // namespace
} // namespace knittsim::physics
