#include "ui/render/hidden_sky.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace knittsim::render {
namespace {

constexpr float kDiameterMm = 0.5F;
constexpr int kNodes = 81;

/// Straight yarns of 8 mm through the middle of the scene, each lifted by `height` and turned by `angle`.
struct Straight {
    float height;
    float angle;
};

SceneFrame sceneOf(const std::vector<Straight>& yarns) {
    SceneFrame frame;
    auto topology = std::make_shared<SceneTopology>();
    for (const Straight& yarn : yarns) {
        frame.nodes.resize((frame.nodes.size() + kMostStride) / kMostStride * kMostStride, {0, 0, 0, -1});
        topology->yarns.push_back({static_cast<std::int32_t>(frame.nodes.size()), kNodes, 0});
        for (int n = 0; n < kNodes; ++n) {
            const float along = 0.1F * static_cast<float>(n);
            frame.nodes.push_back(
                {(along - 4) * std::cos(yarn.angle), (along - 4) * std::sin(yarn.angle), yarn.height, along});
        }
    }
    frame.topology = std::move(topology);
    frame.diameters = {kDiameterMm};
    return frame;
}

std::size_t middleOf(const SceneFrame& frame, std::size_t yarn) {
    return static_cast<std::size_t>(frame.topology->yarns[yarn].first + kNodes / 2);
}

float hiddenFrom(const HiddenSky& sky, const Vec3f& direction) {
    return 0.25F * sky.all + 0.5F * sky.way.dot(direction);
}

TEST(HiddenSky, aLoneYarnHidesNothingFromItself) {
    const SceneFrame frame = sceneOf({{0, 0.3F}});
    for (const HiddenSky& sky : hiddenSky(frame)) {
        EXPECT_NEAR(sky.all, 0, 1e-6);
        EXPECT_NEAR(sky.way.norm(), 0, 1e-6);
    }
}

TEST(HiddenSky, whereTwoYarnsCrossEachHidesTheSideOfTheOther) {
    const SceneFrame frame = sceneOf({{0, 0}, {kDiameterMm, 1.5F}});
    const auto sky = hiddenSky(frame);
    const HiddenSky& lower = sky[middleOf(frame, 0)];
    const HiddenSky& upper = sky[middleOf(frame, 1)];
    EXPECT_GT(hiddenFrom(lower, Vec3f::UnitZ()), 0.2F); // touching
    EXPECT_LT(hiddenFrom(lower, -Vec3f::UnitZ()), 0.1F);
    EXPECT_GT(hiddenFrom(upper, -Vec3f::UnitZ()), 0.2F);
    EXPECT_LT(hiddenFrom(upper, Vec3f::UnitZ()), 0.1F);
    EXPECT_NEAR(lower.way.x(), 0, 0.1F * lower.way.z());
    // Far from the crossing both are free.
    EXPECT_EQ(sky[middleOf(frame, 0) - 30].all, 0);
}

TEST(HiddenSky, fartherYarnHidesLess) {
    float before = std::numeric_limits<float>::infinity();
    for (const float diameters : {1.0F, 1.5F, 2.0F, 3.0F}) {
        const SceneFrame frame = sceneOf({{0, 0}, {diameters * kDiameterMm, 0}});
        const float now = hiddenFrom(hiddenSky(frame)[middleOf(frame, 0)], Vec3f::UnitZ());
        EXPECT_LT(now, before) << diameters;
        before = now;
    }
    EXPECT_EQ(before, 0);
}

TEST(HiddenSky, aTurnedSceneIsHiddenAsMuch) {
    const SceneFrame straight = sceneOf({{0, 0}, {kDiameterMm, 1}});
    const SceneFrame turned = sceneOf({{0, 0.7F}, {kDiameterMm, 1.7F}});
    const auto a = hiddenSky(straight)[middleOf(straight, 0)];
    const auto b = hiddenSky(turned)[middleOf(turned, 0)];
    EXPECT_NEAR(a.all, b.all, 0.02F * a.all);
    EXPECT_NEAR(a.way.z(), b.way.z(), 0.02F * a.all);
}

TEST(HiddenSky, aBrokenShapeIsNoTrouble) {
    SceneFrame frame = sceneOf({{0, 0}, {kDiameterMm, 1}});
    frame.nodes[10] = {std::numeric_limits<float>::quiet_NaN(), 0, 0, 1};
    frame.nodes[20] = {1e30F, 0, 0, 2};
    EXPECT_EQ(hiddenSky(frame).size(), frame.nodes.size());
    addHidden(frame);
    EXPECT_EQ(frame.hidden.size(), frame.nodes.size());
}

} // namespace
} // namespace knittsim::render
