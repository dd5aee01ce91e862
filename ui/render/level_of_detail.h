#pragma once

#include "ui/render/fabric_renderer.h"

#include <Eigen/Core>

#include <array>
#include <optional>
#include <span>

namespace knittsim::render {

constexpr int kRidge = 3; ///< Detail::sides: two faces stand for the half of a tube that is seen

/// How finely a yarn is drawn.
struct Detail {
    int sides = 0;   ///< of the tube; 0: a band does; kRidge
    int stride = 1;  ///< every how many nodes, a power of two up to kMostStride
    float plies = 0; ///< 0 hidden .. 1 fully shown
    float hair = 0;  ///< likewise the loose fibres, which no fixed level brings nearer
};

/// Of the picture, which has more pixels than the window on fine screens.
float millimetresPerPixel(const View& view);

/// From a yarn's width on the screen in pixels and the distance of its nodes; at one level where that is
/// `fixed`.
Detail detailAt(float diameterPixels, float diametersPerSegment, Quality quality,
                std::optional<DetailLevel> fixed = {});

DetailLevel levelOf(const Detail& detail);

/// Of the thickest yarn of a frame, as the renderer draws it; in styles other than Mesh. `looks` by carrier.
DetailLevel levelDrawn(const SceneFrame& frame, std::span<const YarnLook> looks, const View& view);

/// Tests spheres against the four sides of what a camera sees.
class Frustum {
public:
    explicit Frustum(const Camera& camera);

    /// False only when no part of the sphere is in the picture.
    bool sees(const Vec3f& centre, float radius) const;

private:
    std::array<Eigen::RowVector4f, 4> m_planes; ///< normal of unit length pointing inwards, distance
};

} // namespace knittsim::render
