#include "../check_derivatives.h"
#include "chains_for_tests.h"
#include "core/physics/yarn_model/contact_term.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <tuple>

namespace knittsim::physics {
namespace {

TEST(ContactKernel, EndsSmoothlyAndGrowsWithoutBoundTowardsTheCore) {
    const ContactKernel kernel(0.5, 1, 2);
    EXPECT_EQ(kernel.at(1).energy, 0);
    EXPECT_EQ(kernel.at(1.5).slope, 0);
    EXPECT_NEAR(kernel.at(1 - 1e-7).slope, 0, 1e-6);
    EXPECT_NEAR(kernel.at(1 - 1e-9).curvature, 2, 1e-6); // v'' = k z^(-p-1)
    EXPECT_NEAR(kernel.at(0.75).curvature, 2 * std::pow(0.5, -3.4), 1e-9);
    EXPECT_GT(kernel.at(0.51).energy, 20 * kernel.at(0.75).energy);
}

TEST(ContactKernel, SlopeAndCurvatureAreDerivativesEverywhere) {
    const ContactKernel kernel(0.5, 1, 2);
    for (const double d : {0.3, 0.5, 0.5049, 0.5051, 0.52, 0.7, 0.99, 1.2}) {
        constexpr double h = 1e-6;
        const auto up = kernel.at(d + h);
        const auto down = kernel.at(d - h);
        const auto here = kernel.at(d);
        EXPECT_NEAR((up.energy - down.energy) / (2 * h), here.slope, 1e-5 * (1 + std::abs(here.slope))) << d;
        EXPECT_NEAR((up.slope - down.slope) / (2 * h), here.curvature, 1e-4 * (1 + here.curvature)) << d;
    }
}

TEST(ContactKernel, IsContinuousWhereTheParabolaTakesOver) {
    const ContactKernel kernel(0.5, 1, 2);
    const double border = 0.5 + ContactKernel::kLeast * 0.5;
    EXPECT_NEAR(kernel.at(border - 1e-12).energy / kernel.at(border + 1e-12).energy, 1, 1e-8);
    EXPECT_NEAR(kernel.at(border - 1e-12).slope / kernel.at(border + 1e-12).slope, 1, 1e-8);
}

/// Two straight yarns crossing at right angles with nodes `spacing` apart, shifted along themselves.
double crossingEnergy(double spacing, double shift) {
    YarnChains chains;
    chains.yarns = {{1, 0.44, 50, 1, 0.1}};
    const int count = static_cast<int>(4 / spacing) + 1;
    const double half = 0.5 * spacing * (count - 1);
    test::addChain(chains, test::line({-half + shift, 0, 0}, {half + shift, 0, 0}, count));
    test::addChain(chains, test::line({0, -half + shift, 0.6}, {0, half + shift, 0.6}, count));
    return ContactTerm(chains).evaluate(chains.start(), nullptr);
}

TEST(ContactTerm, SumsToTheDoubleIntegralWhereverTheNodesLie) {
    const double integral = crossingEnergy(0.02, 0);
    for (const double shift : {0.0, 0.05, 0.1, 0.15}) {
        EXPECT_NEAR(crossingEnergy(0.3, shift) / integral, 1, 0.02) << shift; // 24 nodes a loop
    }
}

TEST(ContactTerm, CountsBothOrders) {
    // Two nodes alone within reach, each for a length of yarn of 0.05 (ends: half a segment).
    YarnChains chains;
    chains.yarns = {{1, 0.5, 50, 1, 0.1}};
    test::addChain(chains, {{0, 0, 0}, {0, 0, 0.1}});
    test::addChain(chains, {{0, 0.999, 0}, {0, 0.999, -0.1}});
    const double expected = 2 * 0.05 * 0.05 * ContactKernel(0.5, 1, 0.1).at(0.999).energy;
    EXPECT_NEAR(ContactTerm(chains).evaluate(chains.start(), nullptr), expected, 1e-9 * expected);
}

TEST(ContactTerm, AYarnDoesNotTouchItselfWithinItsNextStretch) {
    // A half circle of radius 0.3: its ends are 0.94 apart along the yarn, less than 1.05, and 0.6 in space.
    const auto arc = [](double angle) {
        YarnChains chains;
        chains.yarns = {{1, 0.5, 50, 1, 0.1}};
        std::vector<Eigen::Vector3d> points;
        for (int i = 0; i <= 20; ++i) {
            const double t = angle * i / 20;
            points.emplace_back(0.3 * std::cos(t), 0.3 * std::sin(t), 0);
        }
        test::addChain(chains, points);
        return ContactTerm(chains).evaluate(chains.start(), nullptr);
    };
    EXPECT_EQ(arc(std::numbers::pi), 0);
    EXPECT_GT(arc(1.3 * std::numbers::pi), 0);
}

TEST(ContactTerm, AClosedCourseDoesNotTouchItsOwnContinuation) {
    // A straight course across a narrow cell: its images lie on the same line, farther than it is thick.
    YarnChains chains;
    chains.yarns = {{1, 0.5, 50, 1, 0.1}};
    test::addChain(chains, test::line({0, 0, 0}, {1.5, 0, 0}, 6));
    test::closeLast(chains, 1, 0, 0.3);
    chains.cell = Eigen::Vector2d(1.8, 5);
    EXPECT_EQ(ContactTerm(chains).evaluate(chains.start(), nullptr), 0);
    chains.cell->y() = 0.8;
    EXPECT_GT(ContactTerm(chains).evaluate(chains.start(), nullptr), 0);
}

TEST(ContactTerm, OfACellIsThatOfARepeatInALargerCell) {
    const YarnChains small = test::course(3, 1);
    YarnChains large = small;
    large.cell = Eigen::Vector2d(small.cell->x(), 2 * small.cell->y());
    std::vector<Eigen::Vector3d> above;
    for (Entry i = 0; i < small.nodeCount(); ++i) {
        above.push_back(small.nodes.col(i) + Eigen::Vector3d(0, small.cell->y(), 0));
    }
    test::addChain(large, above);
    test::closeLast(large, 1, 0, small.restLength.back());
    const double one = ContactTerm(small).evaluate(small.start(), nullptr);
    EXPECT_GT(one, 0);
    EXPECT_NEAR(ContactTerm(large).evaluate(large.start(), nullptr), 2 * one, 1e-12 * one);
}

TEST(ContactTerm, KnowsAllPairsHoweverFarTheShapeHasMoved) {
    YarnChains chains = test::twoYarns(5, 1, 3);
    const ContactTerm moved(chains);
    Vector x = chains.start();
    EXPECT_EQ(moved.evaluate(x, nullptr), 0);
    for (int step = 0; step < 23; ++step) {
        for (Entry e = 6; e < 12; ++e) {
            at(x, e).z() -= 0.1;
        }
        const ContactTerm fresh(chains);
        EXPECT_EQ(moved.evaluate(x, nullptr), fresh.evaluate(x, nullptr)) << step;
    }
    EXPECT_GT(moved.evaluate(x, nullptr), 0);
    EXPECT_LT(moved.rebuilds(), 20);
}

TEST(ContactTerm, ThinYarnsDoNotTouch) {
    YarnChains chains = test::twoYarns(5, 1, 0.7);
    ContactTerm term(chains);
    EXPECT_GT(term.evaluate(chains.start(), nullptr), 0);
    term.setThickness(0.4);
    EXPECT_EQ(term.evaluate(chains.start(), nullptr), 0);
    term.setThickness(1);
    EXPECT_GT(term.evaluate(chains.start(), nullptr), 0);
}

TEST(NearPairs, AreAllPairsWithinRange) {
    std::mt19937 random(4);
    Eigen::Matrix3Xd points(3, 60);
    for (Eigen::Index i = 0; i < points.size(); ++i) {
        points.data()[i] = test::uniform(random, -1.5, 1.5);
    }
    const Eigen::Vector2d cell(1.1, 0.9);
    constexpr double range = 0.6;
    for (const bool periodic : {false, true}) {
        std::map<std::tuple<Entry, Entry, int, int>, int> found;
        for (const NearPair& p :
             findNearPairs(points, periodic ? std::optional(cell) : std::nullopt, range)) {
            ++found[{p.a, p.b.node, p.b.across, p.b.up}];
        }
        std::size_t expected = 0;
        const int most = periodic ? 5 : 0;
        for (Entry a = 0; a < 60; ++a) {
            for (Entry b = 0; b < 60; ++b) {
                for (int up = 0; up <= most; ++up) {
                    for (int across = -most; across <= most; ++across) {
                        const bool here = up == 0 && across == 0;
                        if ((here && b <= a) || (up == 0 && across < 0)) {
                            continue;
                        }
                        const Eigen::Vector3d shift(across * cell.x(), up * cell.y(), 0);
                        if ((points.col(b) + shift - points.col(a)).norm() < range) {
                            ++expected;
                            EXPECT_EQ((found[{a, b, across, up}]), 1);
                        }
                    }
                }
            }
        }
        EXPECT_EQ(found.size(), expected);
        EXPECT_GT(expected, 20U);
    }
}

} // namespace
} // namespace knittsim::physics
