#include "core/geometry/bounds.h"
#include "core/geometry/picking.h"
#include "tests/unit/geometry/plain_case.h"

#include <gtest/gtest.h>

#include <limits>

namespace knittsim::geometry {
namespace {

TEST(MeetSegment, hitsTheNearSideOfTheTube) {
    const Ray ray{.origin = {0.5F, 0, 10}, .direction = -Vec3f::UnitZ()};
    const auto hit = meetSegment(ray, {0, 0.3F, 0}, {2, 0.3F, 0}, 0.5F);
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->share, 0.25, 1e-6);
    EXPECT_NEAR(hit->depth, 10 - 0.4, 1e-5); // 3-4-5 triangle
}

TEST(MeetSegment, missesBesideBehindAndBeyondTheEnds) {
    const Ray ray{.origin = {0, 0, 10}, .direction = -Vec3f::UnitZ()};
    EXPECT_FALSE(meetSegment(ray, {-1, 0.6F, 0}, {1, 0.6F, 0}, 0.5F));
    EXPECT_FALSE(meetSegment(ray, {-1, 0, 20}, {1, 0, 20}, 0.5F));
    EXPECT_FALSE(meetSegment(ray, {0.6F, 0, 0}, {3, 0, 0}, 0.5F));
    EXPECT_FALSE(meetSegment(ray, {std::numeric_limits<float>::quiet_NaN(), 0, 0}, {1, 0, 0}, 0.5F));
}

TEST(MeetSegment, takesARoundEndForASegmentAlongTheRay) {
    const Ray ray{.origin = {0.3F, 0, 10}, .direction = -Vec3f::UnitZ()};
    const auto hit = meetSegment(ray, {0, 0, 2}, {0, 0, -2}, 0.5F);
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->depth, 8 - 0.4, 1e-5);
}

TEST(PickYarn, findsTheStitchWhoseLegLiesUnderTheRay) {
    const fabric::Fabric fabric = test::knit("fffff", 6);
    const YarnCurves curves = test::curvesOf(fabric);
    const std::vector<double> diameters{test::kDiameterMm};
    // The loop of needle 2 in course 3: the middle of its left leg, halfway between foot and head.
    const std::size_t loop = 3 * 5 + 2;
    const auto positions = test::relaxedLattice(fabric, test::kLoopMm);
    const auto place = [&](fabric::PointIndex p) {
        const auto e = 3 * static_cast<std::size_t>(fabric.points[static_cast<std::size_t>(p)].entry);
        return Vec3f(positions[e], positions[e + 1], positions[e + 2]);
    };
    const Vec3f middle = 0.5F * (place(fabric.loops[loop].footLeft) + place(fabric.loops[loop].headLeft));
    const auto front = pickYarn(fabric, curves, diameters, {.origin = middle + Vec3f(0, 0, 50)});
    ASSERT_TRUE(front);
    EXPECT_EQ(front->loop, static_cast<machine::LoopIndex>(loop));
    EXPECT_GT(front->place.z(), 0);
    const auto& point = fabric.points[static_cast<std::size_t>(front->point)];
    EXPECT_EQ(point.side, fabric::Side::Left);
    EXPECT_EQ(front->entry, point.entry);
}

TEST(PickYarn, seesTheArcsFromBehindAndNothingBesideTheFabric) {
    const fabric::Fabric fabric = test::knit("fffff", 6);
    const YarnCurves curves = test::curvesOf(fabric);
    const std::vector<double> diameters{test::kDiameterMm};
    const Bounds box = boundsOf(curves.nodes);
    const Ray behind{.origin = box.centre() - Vec3f(0, 0, 50), .direction = Vec3f::UnitZ()};
    const auto pick = pickYarn(fabric, curves, diameters, behind);
    ASSERT_TRUE(pick);
    EXPECT_LT(pick->place.z(), 0);
    EXPECT_FALSE(pickYarn(fabric, curves, diameters, {.origin = box.high + Vec3f(5, 0, 50)}));
}

TEST(MeetPlane, meetsWhatLiesAheadOnly) {
    const Ray ray{.origin = {1, 2, 10}, .direction = -Vec3f::UnitZ()};
    const auto place = meetPlane(ray, {7, 7, 3}, Vec3f::UnitZ());
    ASSERT_TRUE(place);
    EXPECT_LT((*place - Vec3f(1, 2, 3)).norm(), 1e-6);
    EXPECT_FALSE(meetPlane(ray, {0, 0, 20}, Vec3f::UnitZ()));
    EXPECT_FALSE(meetPlane(ray, {0, 0, 3}, Vec3f::UnitX()));
}

TEST(Bounds, leavesOutWhatIsNotFinite) {
    Bounds box;
    EXPECT_TRUE(box.empty());
    box.add({std::numeric_limits<float>::quiet_NaN(), 0, 0});
    EXPECT_TRUE(box.empty());
    box.add({1, 2, 3});
    box.add({-1, 4, 3});
    EXPECT_EQ(box.centre(), Vec3f(0, 3, 3));
    EXPECT_EQ(box.size(), Vec3f(2, 2, 0));
}

} // namespace
} // namespace knittsim::geometry
