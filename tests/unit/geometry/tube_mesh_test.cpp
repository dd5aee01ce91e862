#include "core/geometry/tube_mesh.h"
#include "tests/support/surface.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace knittsim::geometry {
namespace {

std::vector<Vec3f> helix(int nodes) {
    std::vector<Vec3f> result;
    for (int i = 0; i < nodes; ++i) {
        const float t = 0.2F * static_cast<float>(i);
        result.emplace_back(3 * std::cos(t), 3 * std::sin(t), 0.3F * t);
    }
    return result;
}

test::Surface surfaceOf(const TubeMesh& mesh) {
    return {mesh.places, mesh.normals, mesh.triangles};
}

TEST(TubeMesh, IsASphereOutsideOut) {
    for (const int sides : {3, 4, 7, 12}) {
        const test::Surface tube = surfaceOf(makeTube(helix(40), 0.2F, sides));
        EXPECT_TRUE(test::isClosed(tube)) << sides;
        EXPECT_EQ(test::eulerNumber(tube), 2) << sides;
        EXPECT_GT(test::volumeOf(tube), 0) << sides;
    }
}

TEST(TubeMesh, HasTheVolumeOfAStraightRoundBar) {
    const std::vector<Vec3f> nodes{{1, 2, 3}, {1, 2, 8}, {1, 2, 13}};
    const double volume = test::volumeOf(surfaceOf(makeTube(nodes, 0.5F, 64)));
    const double bar = std::numbers::pi * 0.25 * 10;
    const double ball = std::numbers::pi * 4 / 3 * 0.125;
    EXPECT_GT(volume, bar * 0.995);
    EXPECT_LT(volume, bar + ball);
}

TEST(TubeMesh, LiesAtTheRadiusWithUnitNormals) {
    const std::vector<Vec3f> nodes = helix(60);
    const TubeMesh tube = makeTube(nodes, 0.2F, 8);
    ASSERT_EQ(tube.places.size(), tube.normals.size());
    for (std::size_t i = 0; i < tube.places.size(); ++i) {
        EXPECT_NEAR(tube.normals[i].norm(), 1, 1e-5);
        float nearest = std::numeric_limits<float>::max();
        for (const Vec3f& node : nodes) {
            nearest = std::min(nearest, (tube.places[i] - 0.2F * tube.normals[i] - node).norm());
        }
        EXPECT_LT(nearest, 1e-4F);
    }
}

TEST(TubeMesh, TurnsNoMoreThanItsCurve) {
    // In a plane the across direction cannot turn about the yarn at all.
    std::vector<Vec3f> wave;
    for (int i = 0; i < 80; ++i) {
        const float x = 0.1F * static_cast<float>(i);
        wave.emplace_back(x, std::sin(2 * x), 0);
    }
    const int sides = 8;
    const TubeMesh tube = makeTube(wave, 0.1F, sides);
    const Vec3f first = tube.normals[1 + sides];
    for (std::size_t ring = 0; ring < wave.size(); ++ring) {
        EXPECT_NEAR(tube.normals[1 + sides * (ring + 1)].z(), first.z(), 1e-4F) << ring;
    }
}

TEST(TubeMesh, LeavesBadNodesOut) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const std::vector<Vec3f> nodes{{0, 0, 0}, {0, 0, 0}, {nan, 0, 0}, {1, 0, 0}, {1, 0, 0}, {0, 0, 0}};
    const test::Surface tube = surfaceOf(makeTube(nodes, 0.1F, 6));
    EXPECT_TRUE(test::isClosed(tube));
    for (const Vec3f& place : tube.places) {
        EXPECT_TRUE(place.allFinite());
    }
    EXPECT_TRUE(makeTube(std::vector<Vec3f>{{0, 0, 0}, {0, 0, 0}}, 0.1F, 6).places.empty());
    EXPECT_TRUE(makeTube({}, 0.1F, 6).places.empty());
}

TEST(Thinned, KeepsEndsAndStaysNear) {
    const std::vector<Vec3f> nodes = helix(400);
    const float tolerance = 0.2F;
    const std::vector<Vec3f> kept = thinned(nodes, tolerance);
    EXPECT_EQ(kept.front(), nodes.front());
    EXPECT_EQ(kept.back(), nodes.back());
    EXPECT_LT(kept.size(), nodes.size() / 2);
    for (const Vec3f& node : nodes) {
        float nearest = std::numeric_limits<float>::max();
        for (std::size_t i = 1; i < kept.size(); ++i) {
            const Vec3f way = kept[i] - kept[i - 1];
            const float share = std::clamp((node - kept[i - 1]).dot(way) / way.squaredNorm(), 0.0F, 1.0F);
            nearest = std::min(nearest, (kept[i - 1] + share * way - node).norm());
        }
        EXPECT_LE(nearest, tolerance * 1.001F);
    }
    EXPECT_EQ(thinned(nodes, 0).size(), nodes.size());
}

} // namespace
} // namespace knittsim::geometry
