#include "chains_for_tests.h"
#include "core/base/segment_distance.h"
#include "core/physics/yarn_model/yarn_growth.h"
#include "core/physics/yarn_model/yarn_model.h"

#include <gtest/gtest.h>

#include <map>
#include <numbers>

namespace knittsim::physics {
namespace {

/// Two helices wound round each other four times, much nearer than they are thick.
YarnChains plied(double radius) {
    YarnChains chains;
    chains.yarns = {{1, 0.6, 500, 1, 0.03}, {1.4, 0.9, 500, 2, 0.03}};
    for (const int strand : {0, 1}) {
        std::vector<Eigen::Vector3d> points;
        for (int i = 0; i <= 160; ++i) {
            const double turn = 2 * std::numbers::pi * i / 40 + strand * std::numbers::pi;
            points.emplace_back(0.3 * i, radius * std::cos(turn), radius * std::sin(turn));
        }
        test::addChain(chains, points, strand);
    }
    return chains;
}

double distanceOf(const Vector& x, Entry a, Entry b) {
    return closestPoints(at(x, a), at(x, a + 1), at(x, b), at(x, b + 1)).distance;
}

/// Smallest distance of a segment of the first chain from one of the second.
double between(const YarnChains& chains, const Vector& x) {
    double least = 1e9;
    for (Entry a = 0; a + 1 < chains.chains[0].count; ++a) {
        for (Entry b = chains.chains[1].first; b + 1 < chains.nodeCount(); ++b) {
            least = std::min(least, distanceOf(x, a, b));
        }
    }
    return least;
}

/// Half turns of the second strand round the first.
int halfTurns(const YarnChains& chains, const Vector& x) {
    double angle = 0;
    Eigen::Vector3d before = at(x, chains.chains[1].first) - at(x, 0);
    for (Entry i = 1; i < chains.chains[0].count; ++i) {
        const Eigen::Vector3d now = at(x, chains.chains[1].first + i) - at(x, i);
        angle += std::atan2(before.y() * now.z() - before.z() * now.y(),
                            before.y() * now.y() + before.z() * now.z());
        before = now;
    }
    return static_cast<int>(std::lround(angle / std::numbers::pi));
}

TEST(YarnGrowth, PushesYarnsAsFarApartAsTheirCoresAreThick) {
    const YarnChains chains = plied(0.05);
    Vector x = chains.start();
    YarnGrowth growth(chains, {});
    for (int i = 0; i < 300; ++i) {
        growth.sweep(x);
    }
    EXPECT_EQ(growth.thickness(), 1);
    EXPECT_GT(between(chains, x), 0.5 * (0.6 + 0.9));
    EXPECT_NEAR(growth.room(), between(chains, x) / (0.5 * (0.6 + 0.9)), 0.02);
    EXPECT_EQ(halfTurns(chains, x), 8);
}

TEST(YarnGrowth, LetsNoTwoSegmentsComeNearerThanATenthOfTheirDistance) {
    const YarnChains chains = plied(0.05);
    Vector x = chains.start();
    YarnGrowth growth(chains, {});
    double largest = 0;
    for (int sweep = 0; sweep < 60; ++sweep) {
        const Vector old = x;
        largest = std::max(largest, growth.sweep(x));
        for (Entry a = 0; a + 1 < chains.chains[0].count; ++a) {
            for (Entry b = chains.chains[1].first; b + 1 < chains.nodeCount(); ++b) {
                const double start = distanceOf(old, a, b);
                if (start > 1) {
                    continue;
                }
                for (const double share : {0.25, 0.5, 0.75, 1.0}) {
                    const Vector between = old + share * (x - old);
                    ASSERT_GE(distanceOf(between, a, b), 0.099 * start) << "sweep " << sweep;
                }
            }
        }
    }
    EXPECT_GT(largest, 0.01);
}

TEST(YarnGrowth, FixedNodesStay) {
    const YarnChains chains = plied(0.05);
    Vector x = chains.start();
    YarnGrowth growth(chains, {0, 200});
    for (int i = 0; i < 50; ++i) {
        growth.sweep(x);
    }
    EXPECT_EQ(at(x, 0), at(chains.start(), 0));
    EXPECT_EQ(at(x, 200), at(chains.start(), 200));
    EXPECT_NE(at(x, 1), at(chains.start(), 1));
}

/// Near the obstacle a move is cut, far away it is made in whole.
TEST(YarnModel, ShortensAMoveOnlyWhereYarnIsInTheWay) {
    YarnChains chains;
    chains.yarns = {{1, 0.5, 50, 1, 0.1}};
    test::addChain(chains, test::line({0, 0, 0}, {40, 0, 0}, 41));
    test::addChain(chains, test::line({2, -1, 0.2}, {2, 1, 0.2}, 5));
    const YarnModel model(chains);
    const Vector x = chains.start();
    Vector move = Vector::Zero(x.size());
    for (Entry e = 0; e < 41; ++e) {
        at(move, e).z() = 0.17;
    }
    const double uniform = model.allowedStep(x, move, 10);
    model.shorten(x, move, 10);
    EXPECT_LT(uniform, 0.71); // 0.6 of a distance of 0.2
    EXPECT_LE(at(move, 2).z(), StrandGuard::kShare * 0.2 + 1e-12);
    EXPECT_EQ(at(move, 40).z(), 0.17);
    EXPECT_EQ(model.allowedStep(x, move, 10), 1);
}

TEST(NearPairs, OfSomePointsAreThoseOfAllWithOneOfThem) {
    std::mt19937 random(11);
    Eigen::Matrix3Xd points(3, 80);
    std::vector<char> chosen(80);
    for (Eigen::Index i = 0; i < 80; ++i) {
        for (Eigen::Index k = 0; k < 3; ++k) {
            points(k, i) = test::uniform(random, -2, 2);
        }
        chosen[static_cast<std::size_t>(i)] = i % 5 == 0 ? 1 : 0;
    }
    std::map<std::pair<Entry, Entry>, int> some;
    for (const NearPair& p : findNearPairsOf(points, chosen, 0.9)) {
        ++some[{p.a, p.b.node}];
    }
    std::size_t expected = 0;
    for (const NearPair& p : findNearPairs(points, std::nullopt, 0.9)) {
        if (chosen[static_cast<std::size_t>(p.a)] != 0 || chosen[static_cast<std::size_t>(p.b.node)] != 0) {
            ++expected;
            EXPECT_EQ((some[{p.a, p.b.node}]), 1);
        }
    }
    EXPECT_GT(expected, 20U);
    EXPECT_EQ(some.size(), expected);
}

} // namespace
} // namespace knittsim::physics
