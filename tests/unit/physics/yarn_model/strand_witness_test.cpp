#include "chains_for_tests.h"
#include "core/physics/yarn_model/strand_witness.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace knittsim::physics {
namespace {

/// A yarn along x in z = 0 and one along y in z = `gap`.
YarnChains cross(double gap) {
    YarnChains chains;
    chains.yarns = {{1, 0.4, 50, 1, 0.1}};
    test::addChain(chains, test::line({-2, 0, 0}, {2, 0.1, 0}, 6));
    test::addChain(chains, test::line({0.1, -2, gap}, {0, 2, gap}, 6));
    return chains;
}

/// The second yarn of `cross` moved by z.
Vector lifted(const YarnChains& chains, double z) {
    Vector x = chains.start();
    for (Entry e = chains.chains[1].first; e < chains.nodeCount(); ++e) {
        at(x, e).z() += z;
    }
    return x;
}

TEST(StrandWitness, SeesAYarnGoThroughAnother) {
    const YarnChains chains = cross(0.3);
    StrandWitness witness(chains);
    const auto meetings = witness.follow(chains.start(), lifted(chains, -0.6));
    ASSERT_FALSE(meetings.empty());
    // The middle segments of both.
    EXPECT_EQ(meetings.front().a, 2);
    EXPECT_EQ(meetings.front().b, 8);
}

TEST(StrandWitness, SeesItInManySmallStepsToo) {
    const YarnChains chains = cross(0.3);
    StrandWitness witness(chains);
    std::size_t meetings = 0;
    for (int step = 0; step < 100; ++step) {
        meetings += witness.follow(lifted(chains, -0.006 * step), lifted(chains, -0.006 * (step + 1))).size();
    }
    EXPECT_GE(meetings, 1U);
    EXPECT_LE(meetings, 4U);
}

TEST(StrandWitness, LetsPassWhoStayApart) {
    const YarnChains chains = cross(0.3);
    StrandWitness witness(chains);
    // Down to a hair's breadth, up again, and aside farther than anything it knew of.
    const Vector near = lifted(chains, -0.2999);
    EXPECT_TRUE(witness.follow(chains.start(), near).empty());
    EXPECT_TRUE(witness.follow(near, lifted(chains, 5)).empty());
    // Shifted together, even by a long way.
    Vector far = near;
    for (Entry e = 0; e < chains.nodeCount(); ++e) {
        at(far, e) += Eigen::Vector3d(0, 400, -900);
    }
    EXPECT_TRUE(witness.follow(near, far).empty());
}

/// Coplanar at a time when they lie across each other: the only way for segments to pass.
bool passByVolume(const Eigen::Vector3d (&from)[4], const Eigen::Vector3d (&to)[4]) {
    constexpr int kSlices = 4000;
    double before = 0;
    for (int i = 0; i <= kSlices; ++i) {
        const double t = static_cast<double>(i) / kSlices;
        Eigen::Vector3d p[4];
        for (int k = 0; k < 4; ++k) {
            p[k] = (1 - t) * from[k] + t * to[k];
        }
        const Eigen::Vector3d u = p[1] - p[0];
        const Eigen::Vector3d v = p[3] - p[2];
        const Eigen::Vector3d normal = u.cross(v);
        const double volume = normal.dot(p[2] - p[0]);
        if (i > 0 && (volume > 0) != (before > 0)) {
            const auto shareOf = [&](const Eigen::Vector3d& own, const Eigen::Vector3d& other,
                                     const Eigen::Vector3d& way) {
                return way.cross(other).dot(normal) / own.cross(other).dot(normal);
            };
            const double s = shareOf(u, v, p[2] - p[0]);
            const double w = shareOf(v, u, p[0] - p[2]);
            if (s > 0 && s < 1 && w > 0 && w < 1) {
                return true;
            }
        }
        before = volume;
    }
    return false;
}

TEST(StrandWitness, AgreesWithTheVolumesOfRandomPairs) {
    std::mt19937 random(5);
    int passes = 0;
    for (int trial = 0; trial < 400; ++trial) {
        Eigen::Vector3d from[4];
        Eigen::Vector3d to[4];
        for (int k = 0; k < 4; ++k) {
            from[k] = {test::uniform(random, -1, 1), test::uniform(random, -1, 1),
                       test::uniform(random, -1, 1)};
            to[k] = {test::uniform(random, -1, 1), test::uniform(random, -1, 1),
                     test::uniform(random, -1, 1)};
        }
        YarnChains chains;
        chains.yarns = {{1, 0.4, 50, 1, 0.1}};
        test::addChain(chains, {from[0], from[1]});
        test::addChain(chains, {from[2], from[3]});
        Vector end = chains.start();
        for (Entry e = 0; e < 4; ++e) {
            at(end, e) = to[e];
        }
        const bool passed = passByVolume(from, to);
        passes += passed ? 1 : 0;
        EXPECT_EQ(!StrandWitness(chains).follow(chains.start(), end).empty(), passed) << trial;
    }
    EXPECT_GT(passes, 20);
    EXPECT_LT(passes, 380);
}

} // namespace
} // namespace knittsim::physics
