#include "core/physics/conjugate_gradients.h"
#include "core/physics/two_level.h"
#include "knit.h"

#include <gtest/gtest.h>

namespace knittsim::physics {
namespace {

TEST(TwoLevel, IsSymmetricAndPositive) {
    const fabric::Fabric f = test::rib(9, 9);
    const BondingPointModel net = buildBondingPointModel(f, {});
    Model& model = *net.model;
    model.setPinned(3, true);
    model.linearise(machinePositions(f));
    TwoLevel m(model);
    m.build();
    Vector a(model.size());
    Vector b(model.size());
    for (Eigen::Index i = 0; i < a.size(); ++i) {
        a[i] = std::sin(3.0 * static_cast<double>(i));
        b[i] = std::cos(1.3 * static_cast<double>(i * i % 97));
    }
    model.mask(a);
    model.mask(b);
    Vector za;
    Vector zb;
    m.apply(a, za);
    m.apply(b, zb);
    EXPECT_NEAR(za.dot(b), zb.dot(a), 1e-9 * za.norm() * b.norm());
    EXPECT_GT(za.dot(a), 0);
    EXPECT_GT(zb.dot(b), 0);
}

TEST(TwoLevel, NeedsFarFewerIterationsThanBlockJacobi) {
    const fabric::Fabric f = test::plain(40, 40);
    const BondingPointModel net = buildBondingPointModel(f, {});
    Model& model = *net.model;
    const Vector x = machinePositions(f);
    model.linearise(x);
    Vector gradient;
    model.evaluate(x, &gradient);
    TwoLevel two(model);
    two.build();
    BlockJacobi one(model);
    one.build();
    Vector move;
    const auto product = [&](const Vector& v, Vector& y) { model.multiply(v, y); };
    const CgResult slow = conjugateGradients(product, [&](const Vector& r, Vector& z) { one.apply(r, z); },
                                             gradient, move, 1e-3, 2000, {});
    const CgResult quick = conjugateGradients(product, [&](const Vector& r, Vector& z) { two.apply(r, z); },
                                              gradient, move, 1e-3, 2000, {});
    EXPECT_LE(quick.relativeResidual, 1e-3);
    EXPECT_LT(3 * quick.iterations, slow.iterations);
}

TEST(CoarseSpace, KeepsTheNumberOfPatchesBounded) {
    const fabric::Fabric f = test::plain(120, 120);
    const BondingPointModel net = buildBondingPointModel(f, {});
    CoarseSpace space;
    space.cut(*net.model, 2);
    EXPECT_LE(space.patchCount(), CoarseSpace::kMostPatches);
    EXPECT_GT(space.patchCount(), CoarseSpace::kMostPatches / 4);
}

/// Floats pull only when they are taut: patches that lie far apart are joined then, and only then.
TEST(CoarseSpace, TakesAFabricWhoseFloatsGetTaut) {
    std::string lines = "in 1\nin 2\n";
    for (int course = 0; course < 40; ++course) {
        const bool right = course % 2 == 0;
        lines += knittsim::test::pass("knit", 'f', right ? 1 : 38, right ? 38 : 1, 1);
        lines += knittsim::test::pass("knit", 'f', right ? 0 : 39, right ? 39 : 0, 2, 39);
    }
    const fabric::Fabric f = knittsim::test::build(lines);
    const BondingPointModel net = buildBondingPointModel(f, {});
    Model& model = *net.model;
    const Vector x = machinePositions(f);
    CoarseSpace space;
    space.cut(model);
    model.linearise(0.2 * x);
    ASSERT_TRUE(space.build(model));
    model.linearise(4 * x);
    ASSERT_TRUE(space.build(model));
    CoarseSpace fresh;
    fresh.cut(model);
    ASSERT_TRUE(fresh.build(model));
    Vector given = Vector::Zero(x.size());
    Vector wanted = given;
    space.apply(x, given);
    fresh.apply(x, wanted);
    EXPECT_LT((given - wanted).norm(), 1e-9 * wanted.norm());
}

} // namespace
} // namespace knittsim::physics
