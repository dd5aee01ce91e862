#include "chains_for_tests.h"
#include "core/physics/yarn_model/gravity_term.h"
#include "core/physics/yarn_model/relax_yarns.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

/// Shapes that are known in closed form.
namespace knittsim::physics {
namespace {

Vector settle(YarnModel& model, const YarnChains& chains, double residual) {
    Motion motion{chains.start(), Vector::Zero(chains.start().size()), 0};
    YarnRelaxOptions options;
    options.residual = residual;
    const YarnRelaxReport report = relaxYarns(model, motion, options);
    EXPECT_TRUE(report.verdict == StopRule::Verdict::ResidualReached ||
                report.verdict == StopRule::Verdict::Stagnation);
    return motion.positions;
}

TEST(Analytic, AHangingYarnIsACatenary) {
    // Span 10, length 14: with y = a cosh(x / a), 2 a sinh(5 / a) = 14 and the sag is a (cosh(5 / a) - 1).
    double a = 3;
    for (int i = 0; i < 100; ++i) {
        a = 5 / std::asinh(7 / a);
    }
    const double sag = a * (std::cosh(5 / a) - 1);

    YarnChains chains;
    chains.yarns = {{1, 0.5, 1e5, 0.01, 0.1}}; // hardly stretches, hardly resists bending
    constexpr int kCount = 57;
    std::vector<Eigen::Vector3d> points;
    for (int i = 0; i < kCount; ++i) {
        const double x = 10.0 * i / (kCount - 1);
        points.emplace_back(x, -x * (10 - x) / 25 * 4, 0);
    }
    test::addChain(chains, points);
    for (int i = 0; i + 1 < kCount; ++i) {
        chains.restLength[static_cast<std::size_t>(i)] = 14.0 / (kCount - 1);
    }
    YarnModel model(chains);
    model.add(std::make_unique<GravityTerm>(nodeLengths(chains), Eigen::Vector3d(0, -1, 0)));
    model.setPinned(0, true);
    model.setPinned(kCount - 1, true);
    const Vector x = settle(model, chains, 1e-5);
    EXPECT_NEAR(at(x, kCount / 2).y(), -sag, 0.01 * sag);
    EXPECT_NEAR(at(x, kCount / 2).x(), 5, 0.01);
}

TEST(Analytic, AClampedYarnBendsUnderALoadLikeABeam) {
    // Small deflection F L^3 / (3 EI) of a cantilever: first two nodes held, a force on the last one.
    YarnChains chains;
    chains.yarns = {{1, 0.5, 1e4, 2, 0.1}};
    constexpr int kCount = 101;
    test::addChain(chains, test::line({0, 0, 0}, {10, 0, 0}, kCount));
    YarnModel model(chains);
    std::vector<double> load(kCount, 0);
    load.back() = 0.001;
    model.add(std::make_unique<GravityTerm>(load, Eigen::Vector3d(0, 0, -1)));
    model.setPinned(0, true);
    model.setPinned(1, true);
    const Vector x = settle(model, chains, 1e-9);
    const double length = 10 - 0.05; // clamped half way between the two
    EXPECT_NEAR(at(x, kCount - 1).z(), -0.001 * std::pow(length, 3) / (3 * 2), 0.02 * 0.165);
}

/// End of a clamped yarn of length 10 under a load across it of `load` EI / length^2, over its length.
Eigen::Vector2d endOfElastica(double load) {
    YarnChains chains;
    chains.yarns = {{1, 0.5, 1e5, 2, 0.1}};
    constexpr int kCount = 101;
    test::addChain(chains, test::line({0, 0, 0}, {10, 0, 0}, kCount));
    YarnModel model(chains);
    const double length = 10 - 0.05; // clamped half way between the first two nodes
    std::vector<double> weights(kCount, 0);
    weights.back() = load * 2 / (length * length);
    model.add(std::make_unique<GravityTerm>(weights, Eigen::Vector3d(0, 0, -1)));
    model.setPinned(0, true);
    model.setPinned(1, true);
    const Vector x = settle(model, chains, 1e-7);
    return Eigen::Vector2d(at(x, kCount - 1).x() - 0.05, -at(x, kCount - 1).z()) / length;
}

TEST(Analytic, AClampedYarnBendsFarLikeTheElastica) {
    // The pendulum equation with theta = 0 at the clamp and theta' = 0 at the end, integrated numerically; as
    // in the tables of Bisshopp and Drucker 1945.
    const Eigen::Vector2d mild = endOfElastica(1);
    EXPECT_NEAR(mild.x(), 0.9436, 0.002);
    EXPECT_NEAR(mild.y(), 0.3017, 0.002);
    const Eigen::Vector2d far = endOfElastica(5);
    EXPECT_NEAR(far.x(), 0.6124, 0.004);
    EXPECT_NEAR(far.y(), 0.7138, 0.004);
    const Eigen::Vector2d farther = endOfElastica(10);
    EXPECT_NEAR(farther.x(), 0.4450, 0.005);
    EXPECT_NEAR(farther.y(), 0.8106, 0.005);
}

TEST(Analytic, ACoilOfSetYarnResistsByItsCurvatureAlone) {
    // Pulled to a slope a without turning its ends, a coil of n turns has the curvature 2 pi n cos(a) / L;
    // torsion is free. So it is soft at first: 1/2 EI L k0^2 (1 - cos a)^2, with no stiffness at a = 0.
    constexpr int kCount = 401;
    constexpr int kTurns = 5;
    constexpr double kLength = 60;
    const auto coil = [&](double slope) {
        YarnChains chains;
        chains.yarns = {{1, 0.5, 1000, 3, 0.1}};
        const double radius = kLength * std::cos(slope) / (2 * std::numbers::pi * kTurns);
        std::vector<Eigen::Vector3d> points;
        for (int i = 0; i < kCount; ++i) {
            const double share = static_cast<double>(i) / (kCount - 1);
            const double t = 2 * std::numbers::pi * kTurns * share;
            points.emplace_back(radius * std::cos(t), radius * std::sin(t),
                                kLength * std::sin(slope) * share);
        }
        test::addChain(chains, points);
        return chains;
    };
    YarnChains set = coil(0);
    set.yarns[0].set = 1;
    RodBendTerm bend(set);
    bend.takeSet(set.start());
    EXPECT_NEAR(bend.evaluate(set.start(), nullptr), 0, 1e-12);
    const double curvature = 2 * std::numbers::pi * kTurns / kLength;
    for (const double slope : {0.2, 0.5, 1.0}) {
        const double expected = 0.5 * 3 * kLength * std::pow(curvature * (1 - std::cos(slope)), 2);
        EXPECT_NEAR(bend.evaluate(coil(slope).start(), nullptr), expected, 0.01 * expected) << slope;
    }
}

TEST(Analytic, AClosedStraightYarnSpringsIntoACircle) {
    YarnChains chains;
    chains.yarns = {{1, 0.5, 1000, 2, 0.1}};
    constexpr int kCount = 60;
    std::vector<Eigen::Vector3d> points;
    for (int i = 0; i < kCount; ++i) {
        const double t = 2 * std::numbers::pi * i / kCount;
        points.emplace_back(6 * std::cos(t), 3 * std::sin(t), 0.3 * std::sin(3 * t));
    }
    test::addChain(chains, points);
    test::closeLast(chains, 0, 0, 0.5);
    for (double& length : chains.restLength) {
        length = 0.5; // 30 in all
    }
    YarnModel model(chains);
    const Vector x = settle(model, chains, 1e-5);
    const double radius = 30 / (2 * std::numbers::pi);
    EXPECT_NEAR(model.bend().evaluate(x, nullptr), std::numbers::pi * 2 / radius, 0.01);
    EXPECT_NEAR((at(x, 0) - at(x, kCount / 2)).norm(), 2 * radius, 0.02 * radius);
}

TEST(Analytic, TwoHookedLoopsHoldWhatPullsThem) {
    // Two yarns hooked into each other like chain links, their ends drawn apart: the tension of each end is
    // half the pull, and they stay hooked.
    YarnChains chains;
    chains.yarns = {{1, 0.5, 500, 1, 0.03}};
    for (int side = 0; side < 2; ++side) {
        const double s = side == 0 ? 1 : -1;
        std::vector<Eigen::Vector3d> points;
        for (int i = 0; i <= 40; ++i) {
            const double t = std::numbers::pi * (i / 40.0 - 0.5);
            const Eigen::Vector3d p(s * (1.2 * std::cos(t) - 0.4 - 3 * std::pow(std::abs(std::sin(t)), 3)),
                                    side == 0 ? 1.2 * std::sin(t) : 0.0, side == 0 ? 0.0 : 1.2 * std::sin(t));
            points.push_back(p);
        }
        test::addChain(chains, points);
    }
    YarnModel model(chains);
    std::vector<double> pull(82, 0);
    pull[0] = pull[40] = -2;
    pull[41] = pull[81] = 2;
    model.add(std::make_unique<GravityTerm>(pull, Eigen::Vector3d(1, 0, 0)));
    const Vector x = settle(model, chains, 1e-4);
    const std::vector<double> tension = model.stretch().tensions(x);
    for (const std::size_t end : {0U, 39U, 40U, 79U}) {
        EXPECT_NEAR(tension[end], 2, 0.1);
    }
    EXPECT_GT(at(x, 20).x(), at(x, 61).x()); // still hooked
    EXPECT_EQ(model.audit(x).coreOverlaps, 0);
}

} // namespace
} // namespace knittsim::physics
