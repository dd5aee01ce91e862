#include "core/fabric/reduction.h"
#include "knit.h"

#include <gtest/gtest.h>

#include <cmath>

namespace knittsim::physics {
namespace {

using fabric::Fabric;
using test::courseSpacing;
using test::settle;
using test::waleSpacing;

class PlainSizeTest : public ::testing::TestWithParam<std::pair<int, int>> {};

TEST_P(PlainSizeTest, HasTheSpacingsOfMundenWhateverItsSize) {
    const auto [wales, courses] = GetParam();
    const Fabric f = test::plain(wales, courses);
    const BondingPointModel net = buildBondingPointModel(f, {});
    const auto settled = settle(*net.model, f);
    ASSERT_EQ(settled.verdict, StopRule::Verdict::ResidualReached);
    const double l = f.made.loops[0].lengthMm;
    const Vector& x = settled.motion.positions;
    EXPECT_NEAR(l / waleSpacing(f, x, wales, courses / 2), 4.0, 0.08);
    EXPECT_NEAR(l / courseSpacing(f, x, wales, courses, wales / 2), 5.27, 0.1);
}

INSTANTIATE_TEST_SUITE_P(Sizes, PlainSizeTest,
                         ::testing::Values(std::pair{4, 4}, std::pair{12, 12}, std::pair{5, 40},
                                           std::pair{40, 5}, std::pair{30, 30}));

TEST(RestShape, PlainIsAFlatRegularLattice) {
    const Fabric f = test::plain(10, 10);
    const BondingPointModel net = buildBondingPointModel(f, {});
    const Vector x = settle(*net.model, f, "newton-cg", 1e-6).motion.positions;
    const double l = f.made.loops[0].lengthMm;
    const Eigen::Vector3d across =
        test::headOf(f, x, test::loopAt(6, 5, 10)) - test::headOf(f, x, test::loopAt(5, 5, 10));
    const Eigen::Vector3d up =
        test::headOf(f, x, test::loopAt(5, 6, 10)) - test::headOf(f, x, test::loopAt(5, 5, 10));
    for (int wale = 0; wale < 9; ++wale) {
        for (int course = 1; course < 9; ++course) {
            const Eigen::Vector3d here = test::headOf(f, x, test::loopAt(wale, course, 10));
            EXPECT_LT((test::headOf(f, x, test::loopAt(wale + 1, course, 10)) - here - across).norm(),
                      0.01 * l);
            EXPECT_LT((test::headOf(f, x, test::loopAt(wale, course + 1, 10)) - here - up).norm(), 0.01 * l);
        }
    }
    EXPECT_NEAR(across.y(), 0, 0.01 * l);
    EXPECT_NEAR(up.x(), 0, 0.01 * l);
}

TEST(RestShape, RibPullsInAndTheWiderRibMore) {
    const int wales = 16;
    const int courses = 12;
    const auto width = [&](const Fabric& f) {
        const BondingPointModel net = buildBondingPointModel(f, {});
        const auto settled = settle(*net.model, f);
        EXPECT_EQ(settled.verdict, StopRule::Verdict::ResidualReached);
        return waleSpacing(f, settled.motion.positions, wales, courses / 2);
    };
    const double plain = width(test::plain(wales, courses));
    const double one = width(test::rib(wales, courses, 1));
    const double two = width(test::rib(wales, courses, 2));
    // Rods 0.51 to 0.64 and 0.48, swatches 0.72 and 0.62 of plain (PHYSICS-REFERENCE 3.3, PHYSICS 3).
    EXPECT_GT(one / plain, 0.51);
    EXPECT_LT(one / plain, 0.76);
    EXPECT_GT(two / plain, 0.45);
    EXPECT_LT(two, one);
}

TEST(RestShape, RibPutsItsFrontWalesInFront) {
    const Fabric f = test::rib(10, 8);
    const BondingPointModel net = buildBondingPointModel(f, {});
    const Vector x = settle(*net.model, f).motion.positions;
    for (int wale = 2; wale < 8; wale += 2) {
        const double front = test::headOf(f, x, test::loopAt(wale, 4, 10)).z();
        const double rear = test::headOf(f, x, test::loopAt(wale + 1, 4, 10)).z();
        EXPECT_GT(front, rear + 0.1);
    }
}

TEST(RestShape, GarterShortensAndKeepsItsWidth) {
    const int wales = 10;
    const int courses = 12;
    const Fabric plain = test::plain(wales, courses);
    const Fabric garter = test::garter(wales, courses);
    const BondingPointModel plainNet = buildBondingPointModel(plain, {});
    const BondingPointModel garterNet = buildBondingPointModel(garter, {});
    const Vector p = settle(*plainNet.model, plain).motion.positions;
    const Vector g = settle(*garterNet.model, garter).motion.positions;
    const double height =
        courseSpacing(garter, g, wales, courses, 5) / courseSpacing(plain, p, wales, courses, 5);
    const double width = waleSpacing(garter, g, wales, 6) / waleSpacing(plain, p, wales, 6);
    EXPECT_GT(height, 0.64); // rods
    EXPECT_LT(height, 0.78); // swatches 0.76
    EXPECT_NEAR(width, 1.0, 0.1);
}

TEST(RestShape, ALadderOpensFlatAndItsRungsLieAcross) {
    const int wales = 12;
    const int courses = 12;
    const Fabric whole =
        knittsim::test::build(test::backAndForth(wales, courses, [](int) { return 'f'; }) + "drop f5\n");
    const Fabric f = fabric::removeRuns(whole, fabric::findRuns(whole)).fabric;
    const BondingPointModel net = buildBondingPointModel(f, {});
    const auto settled = settle(*net.model, f);
    ASSERT_EQ(settled.verdict, StopRule::Verdict::ResidualReached);
    const Vector& x = settled.motion.positions;
    const double l = f.made.loops[0].lengthMm;
    for (int course = 2; course < courses - 1; ++course) {
        const Eigen::Vector3d left = test::headOf(f, x, test::loopAt(4, course, wales));
        const Eigen::Vector3d right = test::headOf(f, x, test::loopAt(6, course, wales));
        EXPECT_NEAR(left.y(), right.y(), 0.02 * l);
        EXPECT_LT(std::abs(left.z() - right.z()), 0.02 * l);
        // The loop between them was a quarter of l wide; where it was, two sinkers are left.
        EXPECT_GT(right.x() - left.x(), 0.25 * l);
        EXPECT_LT(right.x() - left.x(), 0.55 * l);
        EXPECT_LT(std::abs(left.z() - test::headOf(f, x, test::loopAt(1, course, wales)).z()), 0.1 * l)
            << "the neighbours are slack, they do not bulge";
    }
}

TEST(RestShape, LoopLengthAloneRules) {
    // Munden: neither a stiffer nor a thicker yarn changes the spacings; it changes forces and energies.
    const Fabric f = test::plain(8, 8);
    std::vector<yarn::Yarn> soft(1);
    std::vector<yarn::Yarn> stiff(1);
    stiff[0].bendingStiffness *= 10;
    stiff[0].axialStiffnessMilliNewton *= 10;
    const BondingPointModel a = buildBondingPointModel(f, soft);
    const BondingPointModel b = buildBondingPointModel(f, stiff);
    const Vector start = machinePositions(f);
    EXPECT_GT(b.model->evaluate(start, nullptr), 5 * a.model->evaluate(start, nullptr));
    const Vector x = settle(*a.model, f).motion.positions;
    const Vector y = settle(*b.model, f).motion.positions;
    EXPECT_NEAR(waleSpacing(f, x, 8, 4) / waleSpacing(f, y, 8, 4), 1, 0.01);
    EXPECT_NEAR(courseSpacing(f, x, 8, 8, 4) / courseSpacing(f, y, 8, 8, 4), 1, 0.01);
}

} // namespace
} // namespace knittsim::physics
