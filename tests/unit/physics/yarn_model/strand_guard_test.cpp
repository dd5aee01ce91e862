#include "chains_for_tests.h"
#include "core/base/segment_distance.h"
#include "core/physics/yarn_model/strand_guard.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace knittsim::physics {
namespace {

Eigen::Vector3d point(std::mt19937& random) {
    return {test::uniform(random, -1, 1), test::uniform(random, -1, 1), test::uniform(random, -1, 1)};
}

/// Smallest distance of many points on both.
double sampledDistance(const Eigen::Vector3d& p0, const Eigen::Vector3d& p1, const Eigen::Vector3d& q0,
                       const Eigen::Vector3d& q1) {
    constexpr int n = 60;
    double least = 1e9;
    for (int i = 0; i <= n; ++i) {
        for (int j = 0; j <= n; ++j) {
            least = std::min(least, (p0 + (p1 - p0) * i / n - q0 - (q1 - q0) * j / n).norm());
        }
    }
    return least;
}

TEST(ClosestPoints, AreNoFartherThanAnyOthers) {
    std::mt19937 random(2);
    for (int i = 0; i < 200; ++i) {
        const Eigen::Vector3d p0 = point(random);
        const Eigen::Vector3d p1 = point(random);
        const Eigen::Vector3d q0 = point(random);
        const Eigen::Vector3d q1 = i % 4 == 0 ? Eigen::Vector3d(q0 + 0.7 * (p1 - p0)) : point(random);
        const ClosestPoints c = closestPoints(p0, p1, q0, q1);
        const double sampled = sampledDistance(p0, p1, q0, q1);
        EXPECT_LE(c.distance, sampled + 1e-12) << i;
        EXPECT_GE(c.distance, sampled - 0.05) << i;
        EXPECT_NEAR((p0 + c.s * (p1 - p0) - q0 - c.t * (q1 - q0)).norm(), c.distance, 1e-12);
    }
}

TEST(ClosestPoints, OfPointsAndOfSegmentsOnOneLine) {
    const Eigen::Vector3d o(0, 0, 0);
    const Eigen::Vector3d x(1, 0, 0);
    EXPECT_DOUBLE_EQ(closestPoints(o, o, x, x).distance, 1);
    EXPECT_DOUBLE_EQ(closestPoints(o, x, 3 * x, 3 * x).distance, 2);
    EXPECT_DOUBLE_EQ(closestPoints(o, x, 3 * x, 5 * x).distance, 2);
    EXPECT_DOUBLE_EQ(closestPoints(o, x, 0.5 * x, 5 * x).distance, 0);
}

/// A horizontal yarn and one across that lies `gap` above it.
YarnChains crossing(double gap) {
    YarnChains chains;
    chains.yarns = {{1, 0.4, 50, 1, 0.1}};
    test::addChain(chains, test::line({-2, 0, 0}, {2, 0.1, 0}, 13));
    test::addChain(chains, test::line({0.1, -2, gap}, {0, 2, gap}, 14));
    return chains;
}

/// Signed volume at the crossing: changes its sign when one yarn goes through the other.
double side(const YarnChains& chains, const Vector& x) {
    const Eigen::Vector3d a = at(x, 0);
    const Eigen::Vector3d b = at(x, 12);
    const Eigen::Vector3d c = at(x, 13);
    const Eigen::Vector3d d = at(x, chains.nodeCount() - 1);
    return (b - a).cross(d - c).dot(c - a);
}

TEST(StrandGuard, HoldsAViolentStepBeforeTheOtherYarn) {
    const YarnChains chains = crossing(0.5);
    StrandGuard guard(chains);
    Vector x = chains.start();
    Vector move = Vector::Zero(x.size());
    for (Entry e = 13; e < chains.nodeCount(); ++e) {
        at(move, e) = Eigen::Vector3d(0, 0, -100);
    }
    const double before = side(chains, x);
    for (int i = 0; i < 30; ++i) {
        const double factor = guard.allowed(x, move);
        EXPECT_GE(factor, 0);
        x += factor * move;
        ASSERT_GT(side(chains, x) * before, 0) << i; // never through, however often it tries
    }
    // It did get near: each step takes the same share of what is left.
    EXPECT_LT(StrandGuard(chains).audit(x).smallestDistance, 1e-6);
}

TEST(StrandGuard, LetsYarnsThatMoveTogetherGoAsTheyLike) {
    const YarnChains chains = crossing(0.3);
    StrandGuard guard(chains);
    const Vector x = chains.start();
    Vector apart = Vector::Zero(x.size());
    Vector together = Vector::Zero(x.size());
    for (Entry e = 0; e < chains.nodeCount(); ++e) {
        at(together, e) = Eigen::Vector3d(0, 0, 0.17);
        at(apart, e) = Eigen::Vector3d(0, 0, e < 13 ? 0.17 : -0.17);
    }
    EXPECT_EQ(guard.allowed(x, together), 1);
    EXPECT_NEAR(guard.allowed(x, apart), StrandGuard::kShare * 0.3 / 0.34, 1e-12);
}

TEST(StrandGuard, StandsWhereAStepIsNotANumber) {
    const YarnChains chains = crossing(0.3);
    StrandGuard guard(chains);
    Vector move = Vector::Zero(chains.start().size());
    move[5] = std::nan("");
    EXPECT_EQ(guard.allowed(chains.start(), move), 0);
}

/// Two linked rings of radius 1.
YarnChains rings() {
    YarnChains chains;
    chains.yarns = {{1, 0.4, 50, 1, 0.1}};
    for (int ring = 0; ring < 2; ++ring) {
        std::vector<Eigen::Vector3d> points;
        for (int i = 0; i < 24; ++i) {
            const double t = 2 * std::numbers::pi * i / 24;
            points.emplace_back(ring == 0 ? Eigen::Vector3d(std::cos(t), std::sin(t), 0)
                                          : Eigen::Vector3d(1 + std::cos(t), 0.1, std::sin(t)));
        }
        test::addChain(chains, points);
        test::closeLast(chains, 0, 0, chains.restLength[0]);
    }
    return chains;
}

/// Gauss's linking number of the first two rings: half the signed crossings seen along z.
double linkingNumber(const YarnChains& chains, const Vector& x) {
    double sum = 0;
    for (Entry i = 0; i < 24; ++i) {
        for (Entry j = 0; j < 24; ++j) {
            const Eigen::Vector3d p = at(x, i);
            const Eigen::Vector3d q = at(x, 24 + j);
            const Eigen::Vector3d u = Eigen::Vector3d(at(x, chains.chains[0].place(i + 1).node)) - p;
            const Eigen::Vector3d v = Eigen::Vector3d(at(x, chains.chains[1].place(j + 1).node)) - q;
            const double area = u.x() * v.y() - u.y() * v.x();
            const Eigen::Vector3d w = q - p;
            const double s = (w.x() * v.y() - w.y() * v.x()) / area;
            const double t = (w.x() * u.y() - w.y() * u.x()) / area;
            if (s > 0 && s < 1 && t > 0 && t < 1) {
                const double above = p.z() + s * u.z() - q.z() - t * v.z();
                sum += 0.5 * std::copysign(1, area) * std::copysign(1, above);
            }
        }
    }
    return sum;
}

TEST(StrandGuard, LinkedRingsStayLinkedUnderRandomViolentSteps) {
    const YarnChains chains = rings();
    const double linked = linkingNumber(chains, chains.start());
    ASSERT_EQ(std::abs(linked), 1);
    const auto shaken = [&](bool guarded) {
        std::mt19937 random(8);
        StrandGuard guard(chains);
        Vector x = chains.start();
        int kept = 0;
        for (int i = 0; i < 300; ++i) {
            Vector move(x.size());
            for (Eigen::Index k = 0; k < move.size(); ++k) {
                move[k] = test::uniform(random, -0.5, 0.5) - 0.1 * x[k];
            }
            x += (guarded ? guard.allowed(x, move) : 1) * move;
            kept += linkingNumber(chains, x) == linked ? 1 : 0;
        }
        return kept;
    };
    EXPECT_EQ(shaken(true), 300);
    EXPECT_LT(shaken(false), 200); // the steps are violent indeed
}

TEST(StrandGuard, AStepTakesAtMostItsShareOfADistance) {
    const YarnChains chains = rings();
    std::mt19937 random(3);
    StrandGuard guard(chains);
    Vector x = chains.start();
    double distance = guard.audit(x).smallestDistance;
    for (int i = 0; i < 100; ++i) {
        Vector move(x.size());
        for (Eigen::Index k = 0; k < move.size(); ++k) {
            move[k] = test::uniform(random, -1, 1);
        }
        x += guard.allowed(x, move) * move;
        const double now = StrandGuard(chains).audit(x).smallestDistance;
        // Distances beyond half a yarn are not looked at one by one.
        ASSERT_GE(now, (1 - StrandGuard::kShare) * std::min(distance, 0.5) - 1e-12) << i;
        ASSERT_GT(now, 0) << i;
        distance = now;
    }
}

TEST(StrandGuard, AlsoGuardsImagesWhenTheCellShrinks) {
    YarnChains chains = test::course(2, 1);
    chains.cell->y() = 1.5;
    StrandGuard guard(chains);
    const Vector x = chains.start();
    Vector shrink = Vector::Zero(x.size());
    at(shrink, chains.cellEntry()).y() = -1.5; // courses would fall into one
    const double factor = guard.allowed(x, shrink);
    EXPECT_GT(factor, 0);
    EXPECT_LT(factor, 0.7);
    EXPECT_GT(StrandGuard(chains).audit(x + factor * shrink).smallestDistance, 0);
}

TEST(StrandAudit, CountsOverlapsOfTheCoreAndSaysWhere) {
    const YarnChains apart = crossing(0.45);
    const StrandAudit none = StrandGuard(apart).audit(apart.start());
    EXPECT_EQ(none.coreOverlaps, 0);
    EXPECT_NEAR(none.smallestDistance, 0.45, 1e-3);

    const YarnChains close = crossing(0.25);
    const StrandAudit some = StrandGuard(close).audit(close.start());
    EXPECT_GE(some.coreOverlaps, 1);
    EXPECT_NEAR(some.deepestOverlap, 0.15, 1e-3);
    EXPECT_NEAR(some.worstA, 6, 1);
    EXPECT_NEAR(some.worstB - 13, 6, 1);
    EXPECT_EQ(StrandGuard(close).audit(close.start(), 0.5).coreOverlaps, 0);
}

TEST(StrandAudit, ASharpBendIsNoOverlap) {
    YarnChains chains;
    chains.yarns = {{1, 0.5, 50, 1, 0.1}};
    test::addChain(chains, test::line({0, 0, 0}, {3, 0, 0}, 31)); // nodes nearer than the core
    EXPECT_EQ(StrandGuard(chains).audit(chains.start()).coreOverlaps, 0);
}

} // namespace
} // namespace knittsim::physics
