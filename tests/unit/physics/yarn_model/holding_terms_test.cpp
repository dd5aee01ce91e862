#include "core/physics/yarn_model/axis_term.h"
#include "core/physics/yarn_model/bar_term.h"
#include "core/physics/yarn_model/floor_term.h"
#include "core/physics/yarn_model/knot_term.h"
#include "tests/unit/physics/check_derivatives.h"
#include "tests/unit/physics/yarn_model/chains_for_tests.h"

#include <gtest/gtest.h>

#include <functional>
#include <memory>

namespace knittsim::physics {
namespace {

Vector shaken(unsigned seed) {
    std::mt19937 random(seed);
    Vector x(15);
    for (Eigen::Index i = 0; i < x.size(); ++i) {
        x[i] = test::uniform(random, -2, 2);
    }
    return x;
}

struct Case {
    const char* name;
    std::function<std::unique_ptr<EnergyTerm>()> make;
};

std::vector<Case> cases() {
    return {
        {"axis",
         [] {
             return std::make_unique<AxisTerm>(
                 std::vector<AxisTerm::Spring>{{0, 2, 0.5, 3}, {3, 1, -1, 0.7}, {3, 0, 0, 2}});
         }},
        {"bar",
         [] {
             return std::make_unique<BarTerm>(std::vector<Entry>{0, 2, 4}, shaken(1), 1.7);
         }},
        {"floor",
         [] {
             return std::make_unique<FloorTerm>(-0.3, std::vector<double>{0.5, 0.2, 0, 0.8, 0.5}, 1.3);
         }},
        {"knot", [] {
             return std::make_unique<KnotTerm>(std::vector<KnotTerm::Knot>{{0, 3, 0.4, 2}, {1, 2, 0.1, 5}});
         }}};
}

class HoldingTermTest : public ::testing::TestWithParam<Case> {};

TEST_P(HoldingTermTest, GradientAndHessianAreTheSlopes) {
    const auto term = GetParam().make();
    const Vector x = shaken(5);
    EXPECT_GT(term->evaluate(x, nullptr), 0);
    EXPECT_LT((test::gradientOf(*term, x) - test::differenceGradient(*term, x)).norm(), 1e-7);
    EXPECT_LT((test::denseHessian(*term, x) - test::differenceHessian(*term, x)).norm(), 1e-5);
}

TEST_P(HoldingTermTest, ProductAndDiagonalBelongToTheSameMatrix) {
    const auto term = GetParam().make();
    const Vector x = shaken(6);
    const Eigen::MatrixXd hessian = test::denseHessian(*term, x);
    const Vector v = shaken(7);
    Vector y = Vector::Zero(v.size());
    term->multiply(v, y);
    EXPECT_LT((y - hessian * v).norm(), 1e-12);
    Eigen::Matrix3Xd blocks = Eigen::Matrix3Xd::Zero(3, v.size());
    term->addDiagonal(blocks);
    for (Eigen::Index e = 0; e < 5; ++e) {
        EXPECT_LT((blocks.middleCols<3>(3 * e) - hessian.block<3, 3>(3 * e, 3 * e)).norm(), 1e-12);
    }
}

INSTANTIATE_TEST_SUITE_P(All, HoldingTermTest, ::testing::ValuesIn(cases()),
                         [](const auto& info) { return std::string(info.param.name); });

TEST(BarTerm, GoesWhereverItIsCarriedButDoesNotTurn) {
    const Vector start = shaken(1);
    const BarTerm bar({0, 2, 4}, start, 1.7);
    Vector carried = start;
    Vector turned = start;
    for (Entry e = 0; e < 5; ++e) {
        at(carried, e) += Eigen::Vector3d(3, -1, 2);
        at(turned, e) = Eigen::Vector3d(-at(start, e).y(), at(start, e).x(), at(start, e).z());
    }
    EXPECT_NEAR(bar.evaluate(carried, nullptr), 0, 1e-12);
    EXPECT_GT(bar.evaluate(turned, nullptr), 0.1);
}

TEST(FloorTerm, CarriesYarnAtItsSurfaceAndLetsItGoAbove) {
    const FloorTerm floor(-1, {0.5, 0.5}, 2);
    Vector x = Vector::Zero(6);
    at(x, 0).z() = -0.49;
    at(x, 1).z() = 7;
    EXPECT_EQ(floor.evaluate(x, nullptr), 0);
    at(x, 0).z() = -0.6;
    Vector gradient = Vector::Zero(6);
    EXPECT_NEAR(floor.evaluate(x, &gradient), 0.5 * 2 * 0.1 * 0.1, 1e-12);
    EXPECT_NEAR(gradient[2], -0.2, 1e-12);
}

} // namespace
} // namespace knittsim::physics
