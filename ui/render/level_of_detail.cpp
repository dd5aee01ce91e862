#include "ui/render/level_of_detail.h"

#include <algorithm>

namespace knittsim::render {

Detail detailAt(float diameterPixels, float diametersPerSegment, Quality quality) {
    const bool best = quality == Quality::Best;
    const float pliesFrom = best ? 9.0F : 17.0F;
    Detail detail;
    detail.plies = std::clamp((diameterPixels - pliesFrom) / 8.0F, 0.0F, 1.0F);
    detail.sides = diameterPixels < (best ? 4.0F : 7.0F) ? 0
                   : diameterPixels < pliesFrom          ? 3
                   : diameterPixels < 40.0F              ? 8
                                                         : 14;
    const float longest = best                         ? 0.25F
                          : diameterPixels < 7         ? 0.75F
                          : diameterPixels < pliesFrom ? 0.5F
                                                       : 0.25F;
    while (detail.stride < kMostStride &&
           2.0F * static_cast<float>(detail.stride) * diametersPerSegment <= longest) {
        detail.stride *= 2;
    }
    return detail;
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
