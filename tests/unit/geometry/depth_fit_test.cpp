#include "core/geometry/depth_fit.h"
#include "core/geometry/spline.h"

#include <gtest/gtest.h>

namespace knittsim::geometry {
namespace {

constexpr int kSamples = 4;
constexpr int kControls = 12;

std::vector<std::array<float, 4>> weights() {
    std::vector<std::array<float, 4>> weights;
    for (int i = 0; i < kSamples; ++i) {
        weights.push_back(splineWeights(static_cast<float>(i) / kSamples));
    }
    return weights;
}

constexpr int kNodes = (kControls - 1) * kSamples + 1;

/// Two straight strands of 11 mm that cross at right angles in (5.1, 5.1), the first one along x.
struct Cross {
    std::vector<DepthFit::Spline> splines = {{1, kControls, 0}, {3 + kControls, kControls, kNodes}};
    std::vector<Vec3f> nodes;
    DepthFit::Order order = {20, kNodes + 20, 0.4F, 0.4F, 0.5F};

    explicit Cross(float wave) {
        for (int strand = 0; strand < 2; ++strand) {
            for (int i = 0; i < kNodes; ++i) {
                const float at = 0.25F * static_cast<float>(i);
                const float z = (strand == 0 ? wave : -wave) * std::sin(at);
                nodes.push_back(strand == 0 ? Vec3f(at, 5.1F, z) : Vec3f(5.1F, at, z));
            }
        }
    }

    DepthFit fit() const { return {splines, weights(), nodes}; }
};

float length(const std::vector<Vec3f>& nodes, const YarnPiece& piece) {
    float length = 0;
    for (std::int32_t n = piece.firstNode; n < piece.lastNode; ++n) {
        length += (nodes[static_cast<std::size_t>(n) + 1] - nodes[static_cast<std::size_t>(n)]).norm();
    }
    return length;
}

float depthBetween(const std::vector<Vec3f>& nodes, const DepthFit::Order& o) {
    const auto depth = [&](std::int32_t n, float share) {
        return (1 - share) * nodes[static_cast<std::size_t>(n)].z() +
               share * nodes[static_cast<std::size_t>(n) + 1].z();
    };
    return depth(o.front, o.frontShare) - depth(o.behind, o.behindShare);
}

TEST(DepthFit, YarnThatIsTooShortWavesInDepth) {
    const Cross cross(0.1F);
    DepthFit fit = cross.fit();
    const std::vector<YarnPiece> pieces = {{4, 24, 6}, {24, 40, 4.5F}};
    fit.run(pieces, {}, 0.005F);
    for (const YarnPiece& piece : pieces) {
        EXPECT_NEAR(length(fit.nodes(), piece), piece.storedMm, 0.01F * piece.storedMm);
    }
}

TEST(DepthFit, YarnThatIsTooLongIsDrawnFlat) {
    const Cross cross(1);
    const YarnPiece piece = {4, 40, 9.2F};
    ASSERT_GT(length(cross.nodes, piece), 10);
    DepthFit fit = cross.fit();
    fit.run(std::vector{piece}, {}, 0.005F);
    EXPECT_NEAR(length(fit.nodes(), piece), piece.storedMm, 0.01F * piece.storedMm);
}

TEST(DepthFit, TheProjectionStays) {
    const Cross cross(0.1F);
    DepthFit fit = cross.fit();
    fit.run(std::vector<YarnPiece>{{4, 24, 6}}, std::vector{cross.order}, 0.005F);
    for (std::size_t i = 0; i < cross.nodes.size(); ++i) {
        EXPECT_EQ(fit.nodes()[i].x(), cross.nodes[i].x());
        EXPECT_EQ(fit.nodes()[i].y(), cross.nodes[i].y());
    }
}

TEST(DepthFit, TheStrandInFrontIsInFrontAndTheLengthsStayRight) {
    const Cross cross(0.3F);
    // sin(5.1) < 0: the strand that is to be in front lies behind.
    ASSERT_LT(depthBetween(cross.nodes, cross.order), 0);
    DepthFit fit = cross.fit();
    const std::vector<YarnPiece> pieces = {{4, 40, 10}, {kNodes + 4, kNodes + 40, 10}};
    fit.run(pieces, std::vector{cross.order}, 0.005F);
    EXPECT_GE(depthBetween(fit.nodes(), cross.order), 0.97F * cross.order.leastMm);
    for (const YarnPiece& piece : pieces) {
        EXPECT_NEAR(length(fit.nodes(), piece), piece.storedMm, 0.01F * piece.storedMm);
    }
}

TEST(DepthFit, YarnWhoseProjectionIsTooLongIsLeftAlone) {
    const Cross cross(0.3F);
    DepthFit fit = cross.fit();
    fit.run(std::vector<YarnPiece>{{4, 24, 4.9F}}, {}, 0.005F);
    EXPECT_EQ(fit.nodes(), cross.nodes);
}

TEST(DepthFit, NothingIsDoneForNoYarn) {
    DepthFit fit({}, weights(), {});
    fit.run({}, {}, 0.005F);
    EXPECT_TRUE(fit.nodes().empty());
}

} // namespace
} // namespace knittsim::geometry
