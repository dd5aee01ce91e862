#include "ui/render/level_of_detail.h"

#include <algorithm>
#include <cmath>

namespace knittsim::render {

namespace {

constexpr int kRound = 8;

Detail atLevel(Detail detail, DetailLevel level) {
    switch (level) {
    case DetailLevel::Strokes:
        detail.sides = 0;
        detail.plies = 0;
        break;
    case DetailLevel::Tubes:
        detail.sides = std::max(detail.sides, kRidge);
        detail.plies = 0;
        break;
    case DetailLevel::Yarn:
        detail.sides = std::max(detail.sides, kRidge);
        detail.plies = 1;
        break;
    }
    return detail;
}

} // namespace

float millimetresPerPixel(const View& view) {
    return 2 * view.camera.state().halfHeight / static_cast<float>(std::max(1, view.height));
}

Detail detailAt(float diameterPixels, float diametersPerSegment, Quality quality,
                std::optional<DetailLevel> fixed) {
    const bool best = quality == Quality::Best;
    const float pliesFrom = best ? 6.0F : 12.0F;
    const float roundFrom = best ? 14.0F : 16.0F;
    Detail detail;
    detail.plies = std::clamp((diameterPixels - pliesFrom) / 6.0F, 0.0F, 1.0F);
    detail.hair = std::clamp((diameterPixels - 12) / 24, 0.0F, 1.0F);
    detail.sides = diameterPixels < (best ? 4.0F : 7.0F) ? 0
                   : diameterPixels < roundFrom          ? kRidge
                   : diameterPixels < 40.0F              ? kRound
                                                         : 14;
    // Where yarn bends narrowly its pieces leave the curve by half a pixel at most.
    const float longest = std::clamp(std::sqrt((best ? 1.0F : 2.0F) / std::max(diameterPixels, 1.0F)), 0.25F,
                                     best ? 0.5F : 0.75F);
    while (detail.stride < kMostStride &&
           2.0F * static_cast<float>(detail.stride) * diametersPerSegment <= longest) {
        detail.stride *= 2;
    }
    return fixed ? atLevel(detail, *fixed) : detail;
}

DetailLevel levelOf(const Detail& detail) {
    return detail.plies > 0   ? DetailLevel::Yarn
           : detail.sides > 0 ? DetailLevel::Tubes
                              : DetailLevel::Strokes;
}

DetailLevel levelDrawn(const SceneFrame& frame, std::span<const YarnLook> looks, const View& view) {
    const float perPixel = millimetresPerPixel(view);
    float thickest = 0;
    for (const Chunk& chunk : frame.chunks) {
        const double diameter =
            chunk.carrier < looks.size() ? looks[chunk.carrier].diameterMm : YarnLook().diameterMm;
        thickest = std::max(thickest, static_cast<float>(diameter));
    }
    return levelOf(
        detailAt(thickest / perPixel, frame.segmentMm / std::max(1e-6F, thickest), view.quality, view.level));
}

Frustum::Frustum(const Camera& camera) {
    const Eigen::Matrix4f matrix = camera.projection() * camera.view();
    for (int i = 0; i < 4; ++i) {
        Eigen::RowVector4f plane = matrix.row(3) + (i % 2 == 0 ? 1.0F : -1.0F) * matrix.row(i / 2);
        plane /= std::max(1e-20F, plane.head<3>().norm());
        m_planes[static_cast<std::size_t>(i)] = plane;
    }
}

bool Frustum::sees(const Vec3f& centre, float radius) const {
    return std::ranges::all_of(m_planes, [&](const Eigen::RowVector4f& plane) {
        return plane.head<3>() * centre + plane[3] > -radius;
    });
}

} // namespace knittsim::render
