#include "../check_derivatives.h"
#include "chains_for_tests.h"
#include "core/physics/yarn_model/gravity_term.h"
#include "core/physics/yarn_model/load_step.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

namespace knittsim::physics {
namespace {

/// A thin yarn over a straight bar across it.
YarnChains crossing(double friction) {
    YarnChains chains;
    chains.yarns = {{1, 0.5, 1000, 5, 0.3, friction}};
    test::addChain(chains, test::line({-2, 0, 0.7}, {2, 0, 0.7}, 17));
    test::addChain(chains, test::line({0, -2, 0}, {0, 2, 0}, 17));
    return chains;
}

FrictionTerm lagged(const YarnChains& chains) {
    FrictionTerm term(chains);
    term.lag(ContactTerm(chains), HardCoreTerm(chains), chains.start());
    return term;
}

/// What friction does to the first chain when it has been moved.
Eigen::Vector3d forceOnFirst(const YarnChains& chains, const FrictionTerm& term,
                             const Eigen::Vector3d& move) {
    Vector x = chains.start();
    for (Entry e = 0; e < chains.chains[0].count; ++e) {
        at(x, e) += move;
    }
    const Vector gradient = test::gradientOf(term, x);
    Eigen::Vector3d force = Eigen::Vector3d::Zero();
    for (Entry e = 0; e < chains.chains[0].count; ++e) {
        force -= at(gradient, e);
    }
    return force;
}

double pressure(const YarnChains& chains) {
    const Vector gradient = test::gradientOf(ContactTerm(chains), chains.start());
    double force = 0;
    for (Entry e = 0; e < chains.chains[0].count; ++e) {
        force -= at(gradient, e).z();
    }
    return force;
}

TEST(FrictionTerm, OfACrossingIsMuTimesWhatPressesItHoweverItLies) {
    for (const double shift : {0.0, 0.06, 0.11}) {
        YarnChains chains = crossing(0.3);
        chains.nodes.leftCols(17).colwise() += Eigen::Vector3d(shift, 0, 0);
        const FrictionTerm term = lagged(chains);
        const double limit = 0.3 * pressure(chains);
        ASSERT_GT(limit, 0.01);
        for (const double angle : {0.0, 0.7, 2.0}) {
            const Eigen::Vector3d way(std::cos(angle), std::sin(angle), 0);
            const Eigen::Vector3d force = forceOnFirst(chains, term, 0.05 * way);
            EXPECT_NEAR(force.dot(way) / limit, -1, 0.02) << shift << ' ' << angle;
            EXPECT_LT((force + limit * way).norm(), 0.03 * limit);
        }
    }
}

TEST(FrictionTerm, OfYarnsSideBySideIsMuTimesWhatPressesThem) {
    YarnChains chains;
    chains.yarns = {{1, 0.5, 1000, 5, 0.3, 0.4}};
    test::addChain(chains, test::line({-1, 0, 0.7}, {1, 0, 0.7}, 9));
    test::addChain(chains, test::line({-4, 0.02, 0}, {4, -0.02, 0}, 65)); // nearly side by side
    const Eigen::Vector3d force = forceOnFirst(chains, lagged(chains), {0.05, 0, 0});
    EXPECT_NEAR(force.x() / (0.4 * pressure(chains)), -1, 0.03);
}

TEST(FrictionTerm, GrowsWithTheSlipUpToTheThreshold) {
    const YarnChains chains = crossing(0.3);
    const FrictionTerm term = lagged(chains);
    const double full = forceOnFirst(chains, term, {0.05, 0, 0}).norm();
    constexpr double e = FrictionTerm::kThreshold;
    EXPECT_NEAR(forceOnFirst(chains, term, {0.5 * e, 0, 0}).norm() / full, 0.75, 1e-3); // 2 s - s^2
    EXPECT_NEAR(forceOnFirst(chains, term, {e, 0, 0}).norm() / full, 1, 1e-3);
    EXPECT_EQ(forceOnFirst(chains, term, {0, 0, 0}).norm(), 0);
}

TEST(FrictionTerm, DoesNotHoldYarnsThatPart) {
    const YarnChains chains = crossing(0.3);
    const Eigen::Vector3d force = forceOnFirst(chains, lagged(chains), {0, 0, 0.05});
    EXPECT_LT(force.norm(), 0.05 * 0.3 * pressure(chains));
}

TEST(FrictionTerm, IsNothingWithoutMuOrPressure) {
    const YarnChains smooth = crossing(0);
    EXPECT_EQ(forceOnFirst(smooth, lagged(smooth), {0.05, 0, 0}).norm(), 0);
    YarnChains apart = crossing(0.3);
    apart.nodes.leftCols(17).row(2).array() += 1;
    EXPECT_EQ(forceOnFirst(apart, lagged(apart), {0.05, 0, 0}).norm(), 0);
}

TEST(FrictionTerm, HessianWhereNothingHasMovedYet) {
    const YarnChains chains = crossing(0.3);
    FrictionTerm term = lagged(chains);
    const Eigen::MatrixXd h = test::denseHessian(term, chains.start());
    const Eigen::MatrixXd slope = test::differenceHessian(term, chains.start(), 1e-8);
    EXPECT_GT(h.norm(), 1);
    EXPECT_LT((h - slope).norm(), 1e-4 * h.norm());
    EXPECT_LT(test::gradientOf(term, chains.start()).norm(), 1e-12);
}

/// A limp yarn over something fixed, half way round: one end hangs with force 1, the other one is pinned and
/// is moved along itself.
class Capstan {
public:
    /// Yarn 1, or rather a bar, along z through the origin.
    static YarnChains overDrum(double friction) {
        YarnChains chains;
        chains.yarns = {{0.2, 0.1, 2000, 0.002, 20, friction}, {4, 3, 1e5, 1, 20, friction}};
        hang(chains, 2.09, 66);
        test::addChain(chains, test::line({0, 0, -1.2}, {0, 0, 1.2}, 25), 1);
        return chains;
    }

    /// A ring of the same thickness, its top at the origin.
    static YarnChains overRing(double friction) {
        YarnChains chains;
        chains.yarns = {{1, 0.44, 2000, 0.01, 3, friction}};
        hang(chains, 0.8, 30);
        std::vector<Eigen::Vector3d> ring;
        for (int i = 0; i < 80; ++i) {
            const double t = 2 * std::numbers::pi * i / 80;
            ring.emplace_back(0, 2.5 * (std::cos(t) - 1), 2.5 * std::sin(t));
        }
        test::addChain(chains, ring);
        test::closeLast(chains, 0, 0, (ring[1] - ring[0]).norm());
        return chains;
    }

    explicit Capstan(const YarnChains& chains) : m_model(chains) {
        m_friction = addFriction(m_model, chains);
        std::vector<double> load(static_cast<std::size_t>(chains.nodeCount()), 0);
        load[0] = 1;
        m_model.add(std::make_unique<GravityTerm>(load, Eigen::Vector3d(0, -1, 0)));
        m_end = chains.chains[0].count - 1;
        m_model.setPinned(m_end, true);
        for (Entry e = m_end + 1; e < chains.nodeCount(); ++e) {
            m_model.setPinned(e, true);
        }
        m_motion = {chains.start(), Vector::Zero(m_model.size()), 0};
        step(0);
    }

    /// Pulls the pinned end by so much; what it then holds.
    double step(double pull) {
        at(m_motion.positions, m_end).y() -= pull;
        LoadStepOptions options;
        options.relax.residual = 1e-5;
        const YarnRelaxReport report = makeLoadStep(m_model, m_friction, m_motion, options);
        EXPECT_TRUE(report.verdict == StopRule::Verdict::ResidualReached ||
                    report.verdict == StopRule::Verdict::Stagnation);
        return m_model.stretch().tensions(m_motion.positions)[static_cast<std::size_t>(m_end - 1)];
    }

private:
    /// Half way round at `radius`, and a little down on both sides.
    static void hang(YarnChains& chains, double radius, int segments) {
        const double spacing = std::numbers::pi * radius / segments;
        std::vector<Eigen::Vector3d> points;
        for (int i = 12; i > 0; --i) {
            points.emplace_back(-radius, -spacing * i, 0);
        }
        for (int i = 0; i <= segments; ++i) {
            const double t = std::numbers::pi * (1 - static_cast<double>(i) / segments);
            points.emplace_back(radius * std::cos(t), radius * std::sin(t), 0);
        }
        for (int i = 1; i <= 12; ++i) {
            points.emplace_back(radius, -spacing * i, 0);
        }
        test::addChain(chains, points, 0);
    }

    YarnModel m_model;
    FrictionTerm* m_friction = nullptr;
    Motion m_motion;
    Entry m_end = 0;
};

/// Within a share of the exponent.
void expectCapstan(const std::function<YarnChains(double)>& make, double share) {
    for (const double mu : {0.15, 0.3}) {
        Capstan capstan(make(mu));
        double tension = 0;
        for (int i = 0; i < 6; ++i) {
            tension = capstan.step(0.05);
        }
        EXPECT_NEAR(std::log(tension) / (mu * std::numbers::pi), 1, share) << mu;
        for (int i = 0; i < 6; ++i) {
            tension = capstan.step(-0.05);
        }
        EXPECT_NEAR(std::log(tension) / (mu * std::numbers::pi), -1, share) << mu;
    }
}

TEST(Friction, OfAYarnOverADrumFollowsTheCapstanEquation) {
    expectCapstan(Capstan::overDrum, 0.03);
}

TEST(Friction, OfAYarnHookedIntoARingFollowsTheCapstanEquation) {
    // A soft hook as thick as the yarn: where exactly it turns is not known better.
    expectCapstan(Capstan::overRing, 0.1);
}

TEST(Friction, WithoutItTheDrumTurnsTheForceOnly) {
    EXPECT_NEAR(Capstan(Capstan::overDrum(0)).step(0.05), 1, 0.01);
}

} // namespace
} // namespace knittsim::physics
