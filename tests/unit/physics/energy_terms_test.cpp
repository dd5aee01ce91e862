#include "check_derivatives.h"
#include "core/physics/bend_term.h"
#include "core/physics/curl_term.h"
#include "core/physics/drag_term.h"
#include "core/physics/plate_term.h"
#include "core/physics/rope_term.h"
#include "core/physics/shear_term.h"
#include "core/physics/spring_term.h"
#include "core/physics/straight_term.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <iterator>
#include <memory>
#include <numbers>
#include <random>

namespace knittsim::physics {
namespace {

using test::denseHessian;
using test::differenceGradient;
using test::differenceHessian;
using test::gradientOf;

/// Five entries about a millimetre apart in general position.
Vector shape(unsigned seed) {
    std::mt19937 random(seed);
    Vector x(15);
    for (Eigen::Index i = 0; i < x.size(); ++i) {
        x[i] = 2.0 * static_cast<double>(random()) / static_cast<double>(std::mt19937::max()) - 1.0;
    }
    return x;
}

std::unique_ptr<EnergyTerm> springs(SpringLaw law, double rest) {
    return std::make_unique<SpringTerm>(
        std::move(law), std::vector<Spring>{{0, 1, rest, 3, 2}, {1, 2, rest, 1.5, 0}, {3, 4, rest, 2, 1}});
}

std::unique_ptr<EnergyTerm> rope(double rest) {
    auto term = std::make_unique<RopeTerm>();
    term->add({0, 1, 2, 3}, rest, 2.5);
    term->add({3, 4}, rest, 1.5);
    return term;
}

struct Case {
    const char* name;
    std::function<std::unique_ptr<EnergyTerm>()> make;
    bool exactHessian = false; ///< no projection and no Gauss-Newton in the shapes tried
};

const std::vector<Case>& cases() {
    static const ForceStrainTable table{{0, 0.1, 0.4, 1}, {0, 1, 5, 9}};
    static const std::vector<Case> all{
        {"QuadraticTaut",
         [] {
             return springs({PullLaw::Quadratic, 1, {}}, 0.01);
         },
         true},
        {"QuadraticShort",
         [] {
             return springs({PullLaw::Quadratic, 1, {}}, 5);
         }},
        {"QuarticTaut",
         [] {
             return springs({PullLaw::Quartic, 1, {}}, 0.01);
         },
         true},
        {"QuarticShort",
         [] {
             return springs({PullLaw::Quartic, 1, {}}, 5);
         }},
        {"PowerOne",
         [] {
             return springs({PullLaw::Power, 1, {}}, 0.01);
         },
         true},
        {"PowerThree",
         [] {
             return springs({PullLaw::Power, 3, {}}, 0.4);
         }},
        {"PowerFive",
         [] {
             return springs({PullLaw::Power, 5, {}}, 5);
         }},
        {"TableInside",
         [] {
             return springs({PullLaw::Table, 1, table}, 1.1);
         }},
        {"TableBeyond",
         [] {
             return springs({PullLaw::Table, 1, table}, 0.05);
         },
         true},
        {"Straight",
         [] {
             return std::make_unique<StraightTerm>(
                 std::vector<Straight>{{0, 1, 2, 0.7, 1.2, 3}, {1, 2, 4, 1, 1, 2}});
         },
         true},
        {"Curl",
         [] {
             return std::make_unique<CurlTerm>(
                 std::vector<Curl>{{0, 1, 2, 3, 0.7, 1.2, 0.9, 1.1, 3}, {4, 3, 2, 1, 1, 1, 1, -0.6, 2}});
         }},
        {"Shear",
         [] {
             return std::make_unique<ShearTerm>(
                 std::vector<Corner>{{0, 1, 2, 0.7, 1.2, 3}, {2, 3, 4, 1, 1, 2}});
         }},
        {"Bend",
         [] {
             return std::make_unique<BendTerm>(std::vector<Bend>{{0, 1, 2, 3}, {1, 2, 3, 0.5}});
         }},
        {"RopeTaut", [] { return rope(0.01); }},
        {"RopeSlack", [] { return rope(50); }, true},
        {"Plate", [] { return std::make_unique<PlateTerm>(0.3, 2.0); }, true},
        {"Drag",
         [] {
             auto term = std::make_unique<DragTerm>();
             term->pulls().push_back({3, {1, 2, 3}, 4});
             return term;
         },
         true},
    };
    return all;
}

class EnergyTermTest : public ::testing::TestWithParam<Case> {};

TEST_P(EnergyTermTest, GradientIsTheSlopeOfTheEnergy) {
    const auto term = GetParam().make();
    for (unsigned seed = 1; seed <= 5; ++seed) {
        const Vector x = shape(seed);
        const Vector gradient = gradientOf(*term, x);
        EXPECT_LT((gradient - differenceGradient(*term, x)).norm(), 1e-5 * (1 + gradient.norm())) << seed;
    }
}

TEST_P(EnergyTermTest, HessianIsSymmetricAndNeverNegative) {
    const auto term = GetParam().make();
    for (unsigned seed = 1; seed <= 5; ++seed) {
        const Eigen::MatrixXd h = denseHessian(*term, shape(seed));
        EXPECT_LT((h - h.transpose()).norm(), 1e-12 * (1 + h.norm()));
        const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(h, Eigen::EigenvaluesOnly);
        EXPECT_GT(eigen.eigenvalues().minCoeff(), -1e-10 * (1 + h.norm())) << seed;
    }
}

class ExactHessianTest : public ::testing::TestWithParam<Case> {};

TEST_P(ExactHessianTest, IsTheSlopeOfTheGradient) {
    const auto term = GetParam().make();
    for (unsigned seed = 1; seed <= 5; ++seed) {
        const Vector x = shape(seed);
        const Eigen::MatrixXd h = denseHessian(*term, x);
        EXPECT_LT((h - differenceHessian(*term, x)).norm(), 1e-5 * (1 + h.norm())) << seed;
    }
}

TEST_P(EnergyTermTest, ProductAndDiagonalBelongToTheSameMatrix) {
    const auto term = GetParam().make();
    const Vector x = shape(7);
    const Eigen::MatrixXd h = denseHessian(*term, x);
    const Vector v = shape(8);
    Vector product = Vector::Zero(v.size());
    term->multiply(v, product);
    EXPECT_LT((product - h * v).norm(), 1e-12 * (1 + h.norm()));
    Eigen::Matrix3Xd diagonal = Eigen::Matrix3Xd::Zero(3, v.size());
    term->addDiagonal(diagonal);
    for (Eigen::Index i = 0; i < v.size(); i += 3) {
        EXPECT_LT((diagonal.middleCols<3>(i) - h.block<3, 3>(i, i)).norm(), 1e-12 * (1 + h.norm()));
    }
}

TEST_P(EnergyTermTest, NothingBreaksWhereAllEntriesCoincide) {
    const auto term = GetParam().make();
    const Vector x = Vector::Zero(15);
    EXPECT_TRUE(gradientOf(*term, x).allFinite());
    EXPECT_TRUE(denseHessian(*term, x).allFinite());
}

std::string nameOf(const ::testing::TestParamInfo<Case>& info) {
    return info.param.name;
}

std::vector<Case> exactCases() {
    std::vector<Case> result;
    std::copy_if(cases().begin(), cases().end(), std::back_inserter(result),
                 [](const Case& c) { return c.exactHessian; });
    return result;
}

INSTANTIATE_TEST_SUITE_P(All, EnergyTermTest, ::testing::ValuesIn(cases()), nameOf);
INSTANTIATE_TEST_SUITE_P(All, ExactHessianTest, ::testing::ValuesIn(exactCases()), nameOf);

TEST(CurlTerm, RestsWhereTheCourseHasTurnedByTheAngle) {
    // before at -1, middle at 0 on x; the wale goes up y; t x u = z.
    CurlTerm term({{0, 1, 2, 3, 1, 1, 1, std::numbers::pi / 3, 5}});
    Vector x = Vector::Zero(12);
    at(x, 0) = Eigen::Vector3d(-1, 0, 0);
    at(x, 2) = Eigen::Vector3d(0.5, 0, std::sqrt(0.75));
    at(x, 3) = Eigen::Vector3d(0, 1, 0);
    EXPECT_NEAR(term.evaluate(x, nullptr), 0, 1e-15);
    at(x, 2).z() *= -1;
    EXPECT_NEAR(term.evaluate(x, nullptr), 0.5 * 5 * 3, 1e-12); // |r| = 2 sin 60
}

TEST(BendTerm, EqualsTheSquareOfTheTurn) {
    const BendTerm term({{0, 1, 2, 2}});
    Vector x = Vector::Zero(9);
    at(x, 0) = Eigen::Vector3d(-3, 0, 0);
    at(x, 2) = Eigen::Vector3d(0, 0.5, 0);
    const double quarter = std::numbers::pi / 2;
    EXPECT_NEAR(term.evaluate(x, nullptr), 2 * quarter * quarter, 1e-12);
}

TEST(RopeTerm, PullsWithOneForceAllAlong) {
    RopeTerm term;
    term.add({0, 1, 2}, 3, 10);
    Vector x = Vector::Zero(9);
    at(x, 1) = Eigen::Vector3d(1, 0, 0);
    at(x, 2) = Eigen::Vector3d(1, 4, 0);
    EXPECT_DOUBLE_EQ(term.tension(x, 0), 20); // 1 + 4 - 3 = 2 mm too long
    const Vector gradient = gradientOf(term, x);
    EXPECT_NEAR((at(gradient, 0) - Eigen::Vector3d(-20, 0, 0)).norm(), 0, 1e-12);
    EXPECT_NEAR((at(gradient, 1) - Eigen::Vector3d(20, -20, 0)).norm(), 0, 1e-12);
}

} // namespace
} // namespace knittsim::physics
