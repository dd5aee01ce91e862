#include "ui/render/camera.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace knittsim::render {
namespace {

Camera makeCamera(bool orthographic) {
    Camera camera;
    camera.setViewport(640, 400);
    camera.setState(
        {.target = {3, 5, 1}, .yaw = 0.4F, .pitch = 0.3F, .halfHeight = 20, .orthographic = orthographic});
    return camera;
}

/// Pixel of a place as the matrices have it.
Eigen::Vector2f throughMatrices(const Camera& camera, const Vec3f& place) {
    const Eigen::Vector4f clip = camera.projection() * camera.view() * place.homogeneous();
    return {(clip.x() / clip.w() + 1) * 320, (1 - clip.y() / clip.w()) * 200};
}

class BothProjections : public testing::TestWithParam<bool> {};
INSTANTIATE_TEST_SUITE_P(Camera, BothProjections, testing::Bool());

TEST_P(BothProjections, projectAgreesWithTheMatrices) {
    const Camera camera = makeCamera(GetParam());
    for (const Vec3f& place : {Vec3f(3, 5, 1), Vec3f(-4, 9, 6), Vec3f(10, -8, -3)}) {
        const Vec3f pixel = camera.project(place);
        EXPECT_LT((pixel.head<2>() - throughMatrices(camera, place)).norm(), 0.02);
    }
}

TEST_P(BothProjections, rayThroughAPixelOfAPlacePassesThePlace) {
    const Camera camera = makeCamera(GetParam());
    const Vec3f place(-4, 9, 6);
    const Vec3f pixel = camera.project(place);
    const geometry::Ray ray = camera.rayAt(pixel.x(), pixel.y());
    EXPECT_NEAR(ray.direction.norm(), 1, 1e-5);
    EXPECT_LT((place - ray.origin).cross(ray.direction).norm(), 1e-2);
    EXPECT_GT((place - ray.origin).dot(ray.direction), 0);
}

TEST_P(BothProjections, zoomKeepsWhatLiesUnderTheCursor) {
    Camera camera = makeCamera(GetParam());
    const Vec3f under = camera.state().target + 7 * camera.right() - 4 * camera.up();
    const Vec3f pixel = camera.project(under);
    camera.zoomAt(pixel.x(), pixel.y(), 2.5F);
    EXPECT_NEAR(camera.state().halfHeight, 8, 1e-4);
    EXPECT_LT((camera.project(under) - pixel).head<2>().norm(), 0.02);
}

TEST_P(BothProjections, panFollowsTheMouse) {
    Camera camera = makeCamera(GetParam());
    const Vec3f place = camera.state().target;
    const Vec3f before = camera.project(place);
    camera.pan(31, -17);
    EXPECT_LT((camera.project(place) - before - Vec3f(31, -17, 0)).head<2>().norm(), 0.02);
}

TEST_P(BothProjections, fitShowsTheWholeBoxAndFillsThePicture) {
    for (const ViewSide side : {ViewSide::Front, ViewSide::Back, ViewSide::Top, ViewSide::Left}) {
        Camera camera = makeCamera(GetParam());
        geometry::Bounds box;
        box.add({-10, 20, -2});
        box.add({50, 45, 3});
        camera.look(side);
        camera.setScene(box);
        camera.fit(box);
        float widest = 0;
        for (int corner = 0; corner < 8; ++corner) {
            const Vec3f place((corner & 1) != 0 ? 50.0F : -10.0F, (corner & 2) != 0 ? 45.0F : 20.0F,
                              (corner & 4) != 0 ? 3.0F : -2.0F);
            const Eigen::Vector4f clip = camera.projection() * camera.view() * place.homogeneous();
            for (int axis = 0; axis < 3; ++axis) {
                EXPECT_LE(std::abs(clip[axis] / clip.w()), 1) << "axis " << axis;
            }
            widest = std::max({widest, std::abs(clip.x() / clip.w()), std::abs(clip.y() / clip.w())});
        }
        EXPECT_GT(widest, 0.8);
    }
}

TEST(Camera, frontSeesHigherNeedlesOnTheRightAndBackOnTheLeft) {
    Camera camera;
    camera.setViewport(200, 100);
    camera.look(ViewSide::Front);
    EXPECT_GT(camera.project({5, 0, 0}).x(), 100);
    EXPECT_LT(camera.project({0, 5, 0}).y(), 50); // later courses above
    EXPECT_GT(camera.towardsViewer().z(), 0.99);
    camera.look(ViewSide::Back);
    EXPECT_LT(camera.project({5, 0, 0}).x(), 100);
    EXPECT_LT(camera.project({0, 5, 0}).y(), 50);
}

TEST(Camera, nearerPlacesHaveSmallerDepth) {
    for (const bool orthographic : {true, false}) {
        const Camera camera = makeCamera(orthographic);
        const auto depth = [&](float towards) {
            const Vec3f place = camera.state().target + towards * camera.towardsViewer();
            const Eigen::Vector4f clip = camera.projection() * camera.view() * place.homogeneous();
            return clip.z() / clip.w();
        };
        EXPECT_LT(depth(1), depth(0));
        EXPECT_LT(depth(0), depth(-1));
    }
}

TEST(Camera, orbitStopsAboveAndBelow) {
    Camera camera = makeCamera(true);
    camera.orbit(0, 1e6F);
    EXPECT_NEAR(camera.state().pitch, std::numbers::pi / 2, 1e-5);
    EXPECT_NEAR(camera.up().norm(), 1, 1e-5);
    camera.orbit(0, -1e6F);
    EXPECT_NEAR(camera.state().pitch, -std::numbers::pi / 2, 1e-5);
}

TEST(Camera, putsUselessNumbersRight) {
    Camera camera;
    const float nan = std::numeric_limits<float>::quiet_NaN();
    camera.setViewport(0, -5);
    camera.setState({.target = {nan, 0, 0}, .yaw = nan, .pitch = 9, .halfHeight = -1, .orthographic = false});
    camera.zoomAt(0, 0, 0);
    camera.zoomAt(0, 0, nan);
    EXPECT_TRUE(camera.view().allFinite());
    EXPECT_TRUE(camera.projection().allFinite());
    EXPECT_GT(camera.state().halfHeight, 0);
}

TEST_P(BothProjections, fitLeavesTheEdgesFreeThatAreAskedFor) {
    geometry::Bounds box;
    box.add({-10, 20, -2});
    box.add({10, 120, 2}); // high
    Camera camera = makeCamera(GetParam());
    camera.setViewport(400, 300);
    camera.setScene(box);
    camera.fit(box, 30, 60);
    for (const float y : {20.0F, 120.0F}) {
        for (const float z : {-2.0F, 2.0F}) {
            const float onScreen = camera.project({0, y, z}).y();
            EXPECT_GE(onScreen, 30);
            EXPECT_LE(onScreen, 240);
        }
    }
    EXPECT_LT(camera.project({0, 120, 0}).y(), 60);
    EXPECT_GT(camera.project({0, 20, 0}).y(), 210);
}

TEST(Camera, fitOfNothingChangesNothing) {
    Camera camera = makeCamera(true);
    const CameraState before = camera.state();
    camera.fit({});
    EXPECT_EQ(camera.state(), before);
}

} // namespace
} // namespace knittsim::render
