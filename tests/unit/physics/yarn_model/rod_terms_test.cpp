#include "../check_derivatives.h"
#include "chains_for_tests.h"
#include "core/physics/yarn_model/cell_load_term.h"
#include "core/physics/yarn_model/contact_term.h"
#include "core/physics/yarn_model/friction_term.h"
#include "core/physics/yarn_model/gravity_term.h"
#include "core/physics/yarn_model/hard_core_term.h"
#include "core/physics/yarn_model/rod_bend_term.h"
#include "core/physics/yarn_model/rod_stretch_term.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <iterator>
#include <memory>
#include <numbers>

namespace knittsim::physics {
namespace {

using test::denseHessian;
using test::differenceGradient;
using test::differenceHessian;
using test::gradientOf;

enum class HessianIs : std::uint8_t { Exact, WithoutNegativePart, GaussNewton };

struct Case {
    const char* name;
    std::function<YarnChains(unsigned seed)> chains;
    std::function<std::unique_ptr<EnergyTerm>(const YarnChains&)> make;
    HessianIs hessian = HessianIs::Exact;
};

template<class Term> std::unique_ptr<EnergyTerm> makeTerm(const YarnChains& chains) {
    return std::make_unique<Term>(chains);
}

YarnChains withSet(YarnChains chains, double curvature) {
    chains.restCurvature.assign(chains.restLength.size(), curvature);
    return chains;
}

YarnChains rough(YarnChains chains) {
    for (std::size_t i = 0; i < chains.yarns.size(); ++i) {
        chains.yarns[i].friction = 0.2 + 0.3 * static_cast<double>(i);
    }
    return chains;
}

/// Held at a shape that every coordinate has left by up to `slip`.
std::unique_ptr<EnergyTerm> friction(const YarnChains& chains, double slip) {
    auto term = std::make_unique<FrictionTerm>(chains);
    std::mt19937 random(9);
    Vector reference = chains.start();
    for (double& coordinate : reference) {
        coordinate += test::uniform(random, -slip, slip);
    }
    term->holdAt(reference);
    term->lag(ContactTerm(chains), HardCoreTerm(chains), chains.start());
    return term;
}

const std::vector<Case>& cases() {
    using test::course;
    using test::twoYarns;
    const auto part = HessianIs::WithoutNegativePart;
    static const std::vector<Case> all{
        {"StretchTaut", [](unsigned s) { return twoYarns(s, 0.9, 1); }, makeTerm<RodStretchTerm>},
        {"StretchShort", [](unsigned s) { return twoYarns(s, 1.2, 1); }, makeTerm<RodStretchTerm>, part},
        {"StretchPeriodic", [](unsigned s) { return course(s, 0.9); }, makeTerm<RodStretchTerm>},
        {"BendStraightRest", [](unsigned s) { return twoYarns(s, 1, 1); }, makeTerm<RodBendTerm>},
        {"BendStraightRestPeriodic", [](unsigned s) { return course(s, 1); }, makeTerm<RodBendTerm>},
        {"BendMoreThanSet", [](unsigned s) { return withSet(course(s, 1), 0.1); }, makeTerm<RodBendTerm>},
        {"BendLessThanSet", [](unsigned s) { return withSet(twoYarns(s, 1, 1), 3); }, makeTerm<RodBendTerm>,
         part},
        {"ContactNone", [](unsigned s) { return twoYarns(s, 1, 1.6); }, makeTerm<ContactTerm>},
        {"ContactShell", [](unsigned s) { return twoYarns(s, 1, 0.85); }, makeTerm<ContactTerm>, part},
        {"ContactBelowCore", [](unsigned s) { return twoYarns(s, 1, 0.45); }, makeTerm<ContactTerm>, part},
        {"ContactPeriodic", [](unsigned s) { return course(s, 1); }, makeTerm<ContactTerm>, part},
        {"HardCore", [](unsigned s) { return twoYarns(s, 1, 0.63); }, makeTerm<HardCoreTerm>,
         HessianIs::GaussNewton},
        {"HardCorePeriodic",
         [](unsigned s) {
             YarnChains chains = course(s, 1);
             chains.cell->y() = 0.52;
             return chains;
         },
         makeTerm<HardCoreTerm>, HessianIs::GaussNewton},
        {"FrictionSticks", [](unsigned s) { return rough(twoYarns(s, 1, 0.7)); },
         [](const YarnChains& c) { return friction(c, 0.2 * FrictionTerm::kThreshold); }},
        {"FrictionSlips", [](unsigned s) { return rough(twoYarns(s, 1, 0.7)); },
         [](const YarnChains& c) { return friction(c, 0.1); }},
        {"FrictionOfCores", [](unsigned s) { return rough(twoYarns(s, 1, 0.5)); },
         [](const YarnChains& c) { return friction(c, 0.1); }},
        {"FrictionPeriodic", [](unsigned s) { return rough(course(s, 1)); },
         [](const YarnChains& c) { return friction(c, 0.1); }},
        {"CellLoad", [](unsigned s) { return course(s, 1); },
         [](const YarnChains& c) {
             auto term = std::make_unique<CellLoadTerm>(c.cellEntry());
             term->hold(CellLoadTerm::Width, 3, 7);
             term->pull(CellLoadTerm::Height, 2);
             return term;
         }},
        {"Gravity", [](unsigned s) { return twoYarns(s, 1, 1); },
         [](const YarnChains& c) {
             return std::make_unique<GravityTerm>(nodeLengths(c), Eigen::Vector3d(0, -1, 0.5));
         }},
    };
    return all;
}

class RodTermTest : public ::testing::TestWithParam<Case> {};

TEST_P(RodTermTest, GradientIsTheSlopeOfTheEnergy) {
    for (unsigned seed = 1; seed <= 5; ++seed) {
        const YarnChains chains = GetParam().chains(seed);
        const auto term = GetParam().make(chains);
        const Vector x = chains.start();
        const Vector gradient = gradientOf(*term, x);
        EXPECT_LT((gradient - differenceGradient(*term, x)).norm(), 1e-6 * (1 + gradient.norm())) << seed;
    }
}

TEST_P(RodTermTest, HessianIsTheSlopeOfTheGradientWithoutItsNegativePart) {
    for (unsigned seed = 1; seed <= 5; ++seed) {
        const YarnChains chains = GetParam().chains(seed);
        const auto term = GetParam().make(chains);
        const Vector x = chains.start();
        const Eigen::MatrixXd h = denseHessian(*term, x);
        const double scale = 1 + h.norm();
        EXPECT_LT((h - h.transpose()).norm(), 1e-12 * scale);
        const auto eigenvalues = [](const Eigen::MatrixXd& m) {
            return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(m, Eigen::EigenvaluesOnly).eigenvalues();
        };
        EXPECT_GT(eigenvalues(h).minCoeff(), -1e-10 * scale) << seed;
        Eigen::MatrixXd missing = differenceHessian(*term, x) - h;
        missing = (0.5 * (missing + missing.transpose())).eval();
        if (GetParam().hessian == HessianIs::Exact) {
            EXPECT_LT(missing.norm(), 1e-5 * scale) << seed;
        } else if (GetParam().hessian == HessianIs::WithoutNegativePart) {
            EXPECT_LT(eigenvalues(missing).maxCoeff(), 1e-5 * scale) << seed;
        }
    }
}

TEST_P(RodTermTest, ProductAndDiagonalBelongToTheSameMatrix) {
    const YarnChains chains = GetParam().chains(7);
    const auto term = GetParam().make(chains);
    const Vector x = chains.start();
    const Eigen::MatrixXd h = denseHessian(*term, x);
    const Vector v = Vector::LinSpaced(x.size(), -1, 2).array().sin();
    Vector product = Vector::Zero(v.size());
    term->multiply(v, product);
    EXPECT_LT((product - h * v).norm(), 1e-11 * (1 + h.norm()));
    Eigen::Matrix3Xd diagonal = Eigen::Matrix3Xd::Zero(3, v.size());
    term->addDiagonal(diagonal);
    for (Eigen::Index i = 0; i < v.size(); i += 3) {
        EXPECT_LT((diagonal.middleCols<3>(i) - h.block<3, 3>(i, i)).norm(), 1e-12 * (1 + h.norm()));
    }
}

TEST_P(RodTermTest, NothingBreaksWhereAllNodesCoincide) {
    const YarnChains chains = GetParam().chains(1);
    const auto term = GetParam().make(chains);
    Vector x = Vector::Zero(chains.start().size());
    if (chains.cell) {
        x.tail<3>() = chains.start().tail<3>();
    }
    EXPECT_TRUE(gradientOf(*term, x).allFinite());
    EXPECT_TRUE(denseHessian(*term, x).allFinite());
}

INSTANTIATE_TEST_SUITE_P(All, RodTermTest, ::testing::ValuesIn(cases()),
                         [](const ::testing::TestParamInfo<Case>& info) { return info.param.name; });

YarnChains ring(int count, double radius) {
    YarnChains chains;
    chains.yarns = {{1, 0.5, 100, 3, 0.1}};
    std::vector<Eigen::Vector3d> points;
    for (int i = 0; i < count; ++i) {
        const double t = 2 * std::numbers::pi * i / count;
        points.emplace_back(radius * std::cos(t), radius * std::sin(t), 0);
    }
    test::addChain(chains, points);
    test::closeLast(chains, 0, 0, chains.restLength[0]);
    return chains;
}

TEST(RodBendTerm, OfARingIsThatOfItsCurvature) {
    // 1/2 EI k^2 over the whole length: pi EI / r.
    const YarnChains chains = ring(200, 4);
    const RodBendTerm term(chains);
    EXPECT_NEAR(term.evaluate(chains.start(), nullptr), std::numbers::pi * 3 / 4, 1e-3);
    const std::vector<double> curvatures = term.curvatures(chains.start());
    EXPECT_NEAR(*std::min_element(curvatures.begin(), curvatures.end()), 0.25, 1e-4);
    EXPECT_NEAR(*std::max_element(curvatures.begin(), curvatures.end()), 0.25, 1e-4);
}

TEST(RodBendTerm, OfARingThatIsFullySetVanishes) {
    const YarnChains straight = ring(50, 4);
    YarnChains set = straight;
    set.restCurvature = RodBendTerm(straight).curvatures(straight.start());
    EXPECT_NEAR(RodBendTerm(set).evaluate(set.start(), nullptr), 0, 1e-20);
}

TEST(RodBendTerm, EveryYarnTakesItsOwnSet) {
    YarnChains chains = ring(50, 4);
    chains.yarns = {{1, 0.5, 100, 3, 0.1, 0, 0.25}, {1, 0.5, 100, 3, 0.1, 0, 1}};
    test::addChain(chains, {{0, 0, 9}, {1, 0, 9}, {1, 1, 9}}, 1);
    RodBendTerm bend(chains);
    const std::vector<double> before = bend.curvatures(chains.start());
    bend.takeSet(chains.start());
    const std::vector<double> rest = bend.restCurvatures();
    EXPECT_NEAR(rest[7], 0.25 * before[7], 1e-12);
    EXPECT_NEAR(rest[51], before[51], 1e-12);
    EXPECT_GT(rest[51], 0.5);
    // As if it had been made like that.
    chains.restCurvature = rest;
    EXPECT_NEAR(RodBendTerm(chains).evaluate(chains.start(), nullptr), bend.evaluate(chains.start(), nullptr),
                1e-12);
}

TEST(RodStretchTerm, PullsWithForceByStrain) {
    YarnChains chains;
    chains.yarns = {{1, 0.5, 100, 1, 0.1}};
    test::addChain(chains, test::line({0, 0, 0}, {2.2, 0, 0}, 3), 0, 1 / 1.1);
    for (const double tension : RodStretchTerm(chains).tensions(chains.start())) {
        EXPECT_NEAR(tension, 10, 1e-12); // EA times 10 %
    }
}

TEST(YarnChains, SayWhatIsWrongWithThem) {
    YarnChains good = test::course(1, 1);
    EXPECT_STREQ(good.problem(), "");
    const auto spoilt = [&](const std::function<void(YarnChains&)>& spoil) {
        YarnChains bad = good;
        spoil(bad);
        return std::string(bad.problem());
    };
    EXPECT_NE(spoilt([](YarnChains& c) { c.restLength[2] = 0; }), "");
    EXPECT_NE(spoilt([](YarnChains& c) { c.restLength.pop_back(); }), "");
    EXPECT_NE(spoilt([](YarnChains& c) { c.chains[0].yarn = 1; }), "");
    EXPECT_NE(spoilt([](YarnChains& c) { c.chains[0].count = 9; }), "");
    EXPECT_NE(spoilt([](YarnChains& c) { c.yarns[0].coreDiameter = 1; }), "");
    EXPECT_NE(spoilt([](YarnChains& c) { c.cell->x() = 0; }), "");
    EXPECT_NE(spoilt([](YarnChains& c) { c.cell.reset(); }), "");
    EXPECT_NE(spoilt([](YarnChains& c) { c.nodes(1, 3) = std::nan(""); }), "");
}

} // namespace
} // namespace knittsim::physics
