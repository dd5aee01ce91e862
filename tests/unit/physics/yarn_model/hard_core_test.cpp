#include "chains_for_tests.h"
#include "core/physics/yarn_model/contact_term.h"
#include "core/physics/yarn_model/hard_core_term.h"

#include <gtest/gtest.h>

namespace knittsim::physics {
namespace {

/// Two yarns crossing half way between their nodes, which are 0.5 apart.
YarnChains crossing(double gap) {
    YarnChains chains;
    chains.yarns = {{1, 0.4, 50, 1, 0.1}};
    test::addChain(chains, test::line({-1.75, 0, 0}, {1.75, 0, 0}, 8));
    test::addChain(chains, test::line({0, -1.75, gap}, {0, 1.75, gap}, 8));
    return chains;
}

TEST(HardCoreTerm, ActsOnlyNearTheCore) {
    EXPECT_EQ(HardCoreTerm(crossing(0.45)).evaluate(crossing(0.45).start(), nullptr), 0);
    EXPECT_GT(HardCoreTerm(crossing(0.42)).evaluate(crossing(0.42).start(), nullptr), 0);
}

TEST(HardCoreTerm, SeesThinYarnsThatPassBetweenNodes) {
    const YarnChains chains = crossing(0.1);
    ContactTerm nodes(chains);
    HardCoreTerm cores(chains);
    nodes.setThickness(0.25); // core 0.1, outer 0.25; the nearest nodes are 0.36 apart
    cores.setThickness(0.25);
    EXPECT_EQ(nodes.evaluate(chains.start(), nullptr), 0);
    Vector gradient = Vector::Zero(chains.start().size());
    EXPECT_GT(cores.evaluate(chains.start(), &gradient), 0);
    EXPECT_GT(at(gradient, 3).z(), 0); // pushes the lower one down, the upper one up
    EXPECT_LT(at(gradient, 8 + 3).z(), 0);
}

/// Which ends of two segments side by side are the nearest is decided by nothing: the force must not jump.
TEST(HardCoreTerm, IsSmoothWhereSegmentsLieSideBySide) {
    const auto forceAt = [](double tilt) {
        YarnChains chains;
        chains.yarns = {{1, 0.4, 50, 1, 0.1}};
        test::addChain(chains, test::line({0, 0, 0}, {0.4, 0, 0}, 2));
        test::addChain(chains, test::line({0, 0, 0.42 - tilt}, {0.4, 0, 0.42 + tilt}, 2));
        Vector gradient = Vector::Zero(chains.start().size());
        HardCoreTerm(chains).evaluate(chains.start(), &gradient);
        return gradient;
    };
    const Vector level = forceAt(0);
    EXPECT_GT(level.norm(), 0);
    EXPECT_LT((forceAt(1e-5) - forceAt(-1e-5)).norm(), 0.1 * level.norm());
}

TEST(HardCoreTerm, LeavesAYarnsOwnBendAlone) {
    YarnChains chains;
    chains.yarns = {{1, 0.5, 50, 1, 0.1}};
    test::addChain(chains, test::line({0, 0, 0}, {3, 0, 0}, 31)); // nodes nearer than the core
    EXPECT_EQ(HardCoreTerm(chains).evaluate(chains.start(), nullptr), 0);
}

} // namespace
} // namespace knittsim::physics
