#include "../check_derivatives.h"
#include "chains_for_tests.h"
#include "core/physics/conjugate_gradients.h"
#include "core/physics/plate_term.h"
#include "core/physics/yarn_model/banded_cholesky.h"
#include "core/physics/yarn_model/knit_cell.h"
#include "core/physics/yarn_model/relax_cell.h"
#include "core/physics/yarn_model/yarn_model.h"
#include "core/physics/yarn_model/yarn_preconditioner.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

namespace knittsim::physics {
namespace {

class BandedCholeskyTest : public ::testing::TestWithParam<std::pair<Entry, bool>> {};

TEST_P(BandedCholeskyTest, SolvesTheSystemItWasGiven) {
    const auto [count, closed] = GetParam();
    std::mt19937 random(5);
    const Eigen::Index n = Eigen::Index{3} * count;
    Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(n, n);
    BandedCholesky band(count, closed);
    // A sum of squares of second differences and of a little of everything.
    for (Entry i = 0; i < count; ++i) {
        const std::array<Entry, 3> nodes{i, (i + 1) % count, (i + 2) % count};
        const Matrix3 root = Matrix3::Random();
        const Matrix3 s = root * root.transpose();
        const std::array<double, 3> weights{1, -2, 1};
        for (std::size_t k = 0; k < 3; ++k) {
            for (std::size_t l = 0; l < 3; ++l) {
                if (!closed && i + 2 >= count) {
                    continue;
                }
                const Matrix3 block = weights[k] * weights[l] * s;
                band.add(nodes[k], nodes[l], block);
                dense.block<3, 3>(3 * nodes[k], 3 * nodes[l]) += block;
            }
        }
        const Matrix3 ground = test::uniform(random, 0.5, 1) * Matrix3::Identity();
        band.add(i, i, ground);
        dense.block<3, 3>(3 * i, 3 * i) += ground;
    }
    ASSERT_TRUE(band.factorise());
    const Vector b = Vector::LinSpaced(n, 0, 9).array().cos();
    Vector x = b;
    band.solve(x);
    EXPECT_LT((dense * x - b).norm(), 1e-11 * b.norm());
    EXPECT_NEAR(band.square(b), b.dot(dense * b), 1e-10 * b.dot(dense * b));
}

INSTANTIATE_TEST_SUITE_P(All, BandedCholeskyTest,
                         ::testing::Values(std::pair{2, false}, std::pair{3, false}, std::pair{40, false},
                                           std::pair{3, true}, std::pair{4, true}, std::pair{5, true},
                                           std::pair{24, true}, std::pair{25, true}));

TEST(BandedCholesky, RefusesWhatIsNotDefinite) {
    BandedCholesky band(2, false);
    band.add(0, 0, Matrix3::Identity());
    band.add(1, 1, -Matrix3::Identity());
    EXPECT_FALSE(band.factorise());
}

YarnChains cell(int wales, int courses) {
    KnitPurl pattern{wales, courses, {}};
    for (int i = 0; i < wales * courses; ++i) {
        pattern.faces.push_back(i % 3 == 0 ? -1 : 1);
    }
    RodYarn yarn;
    yarn.coreDiameter = 0.44;
    yarn.contactStiffness = 0.03;
    return knitCell(pattern, std::vector<double>(pattern.faces.size(), 8.0), yarn, {.nodesPerLoop = 16});
}

/// The matrix whose inverse a preconditioner is, from its action.
Eigen::MatrixXd inverseOf(const Preconditioner& p, Eigen::Index size) {
    Eigen::MatrixXd result(size, size);
    Vector z;
    for (Eigen::Index i = 0; i < size; ++i) {
        p.apply(Vector::Unit(size, i), z);
        result.col(i) = z;
    }
    return result;
}

TEST(YarnPreconditioner, IsSymmetricDefiniteAndTheInverseOfItsMetric) {
    YarnModel model(cell(2, 1));
    const Vector x = cell(2, 1).start();
    model.setPinned(5, true);
    model.linearise(x);
    YarnPreconditioner p(model);
    p.build();
    const Eigen::MatrixXd inverse = inverseOf(p, x.size());
    EXPECT_LT((inverse - inverse.transpose()).norm(), 1e-8 * inverse.norm());
    Vector v = Vector::LinSpaced(x.size(), 0, 20).array().sin();
    model.mask(v);
    Vector z;
    p.apply(v, z);
    EXPECT_GT(v.dot(z), 0);
    EXPECT_NEAR(p.halfSquare(z), 0.5 * v.dot(z), 1e-8 * v.dot(z)); // z P z = v z
    EXPECT_EQ(at(z, 5).norm(), 0);
}

TEST(YarnPreconditioner, IsExactWithoutContactAndSurroundings) {
    for (const bool periodic : {false, true}) {
        YarnChains chains = periodic ? test::course(2, 0.95) : test::twoYarns(2, 0.95, 3);
        if (periodic) {
            chains.cell->y() = 30; // no contact
        }
        YarnModel model(chains);
        model.linearise(chains.start());
        YarnPreconditioner p(model);
        p.build();
        Vector v = Vector::LinSpaced(model.size(), 0, 7).array().cos();
        Vector product;
        Vector z;
        model.multiply(v, product);
        p.apply(product, z);
        EXPECT_LT((z - v).norm(), 1e-4 * v.norm()) << periodic;
    }
}

TEST(YarnPreconditioner, MakesConjugateGradientsQuick) {
    // At rest, where contact is as stiff as the yarn makes it.
    RodYarn yarn;
    yarn.coreDiameter = 0.57;
    yarn.contactStiffness = 0.03;
    const CellShape rest = relaxCell({4, 4, std::vector<int>(16, 1)}, std::vector<double>(16, 12), yarn);
    YarnModel model(rest.chains);
    const Vector& x = rest.shape;
    model.linearise(x);
    YarnPreconditioner p(model);
    constexpr double kInertia = 0.3; // as in an implicit step of PHYSICS 2
    p.build(kInertia);
    const Vector force = Vector::LinSpaced(x.size(), 0, 999).array().sin();
    const auto product = [&](const Vector& v, Vector& y) {
        model.multiply(v, y);
        for (Entry e = 0; e < model.entryCount(); ++e) {
            at(y, e) += kInertia * model.mass()[e] * at(v, e);
        }
    };
    const auto alone = [](const Vector& r, Vector& z) { z = r; };
    const auto banded = [&](const Vector& r, Vector& z) { p.apply(r, z); };
    Vector move;
    const CgResult with = conjugateGradients(product, banded, force, move, 1e-2, 3000, {});
    const CgResult without = conjugateGradients(product, alone, force, move, 1e-2, 3000, {});
    EXPECT_LE(with.relativeResidual, 1e-2);
    EXPECT_LT(4 * with.iterations, without.iterations) << with.iterations;
}

TEST(YarnPreconditioner, GivesTheSameBitsForAnyNumberOfThreads) {
    const YarnChains chains = cell(25, 60); // 24,000 nodes: enough for threads to be used
    Vector x = chains.start();
    Vector z[3];
    for (int threads = 1; threads <= 3; ++threads) {
        YarnModel model(chains, threads);
        model.linearise(x);
        YarnPreconditioner p(model);
        p.build();
        Vector v = Vector::LinSpaced(x.size(), 0, 700).array().sin();
        p.apply(v, z[threads - 1]);
    }
    EXPECT_EQ(z[0], z[1]);
    EXPECT_EQ(z[0], z[2]);
}

TEST(YarnModel, ACellShrinksByNoMoreThanAllowedInOneStep) {
    const YarnChains chains = cell(2, 2);
    const YarnModel model(chains);
    const Vector x = chains.start();
    Vector move = Vector::Zero(x.size());
    at(move, chains.cellEntry()).y() = -chains.cell->y();
    const double allowed = model.allowedStep(x, move, 0.1);
    EXPECT_GT(allowed, 0);
    EXPECT_LE(allowed, 0.1);
}

TEST(YarnModel, ItsParts) {
    // Energy is the sum of the terms; the Hessian's product belongs to the gradient.
    const YarnChains chains = cell(2, 2);
    YarnModel model(chains);
    model.add(std::make_unique<PlateTerm>(0.2, 0.7));
    const Vector x = chains.start();
    const double sum = model.stretch().evaluate(x, nullptr) + model.bend().evaluate(x, nullptr) +
                       model.contact().evaluate(x, nullptr);
    EXPECT_GT(model.evaluate(x, nullptr), sum); // the plates
    Vector gradient;
    const double energy = model.evaluate(x, &gradient);
    const Vector v = Vector::LinSpaced(x.size(), 0, 20).array().sin();
    constexpr double h = 1e-7;
    EXPECT_NEAR((model.evaluate(x + h * v, nullptr) - model.evaluate(x - h * v, nullptr)) / (2 * h),
                gradient.dot(v), 1e-5 * std::abs(energy));
}

} // namespace
} // namespace knittsim::physics
