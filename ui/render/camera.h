#pragma once

#include "core/geometry/bounds.h"
#include "core/geometry/picking.h"

#include <Eigen/Geometry>

#include <cstdint>

namespace knittsim::render {

/// From where the fabric is seen. Front: the viewer stands before the front bed.
enum class ViewSide : std::uint8_t { Front, Back, Left, Right, Top, Bottom };

/// What a camera is; plain value, for saving.
struct CameraState {
    Vec3f target = Vec3f::Zero(); ///< mm, in the middle of the picture
    float yaw = 0;         ///< radians, about the fabric's y axis; 0 looks at the front, pi at the back
    float pitch = 0;       ///< radians, > 0 from above; -pi/2 .. pi/2
    float halfHeight = 50; ///< mm from the middle of the picture to its upper edge, in the target's plane
    bool orthographic = true;

    bool operator==(const CameraState&) const = default;
};

/// A turntable camera. Knows nothing of OpenGL; all pixels are counted from the upper left corner.
class Camera {
public:
    const CameraState& state() const { return m_state; }

    /// Numbers that are not finite or out of range are put right.
    void setState(const CameraState& state);

    /// Pixels; a size of zero counts as one.
    void setViewport(int width, int height);

    /// `scene` bounds the depth of the picture; give it whenever the fabric changes.
    void setScene(const geometry::Bounds& scene) { m_scene = scene; }

    /// Moves back until the whole box is seen, with a margin; keeps direction and projection. `above`,
    /// `below`: pixels at the edges of the picture that are wanted for something else.
    void fit(const geometry::Bounds& box, float above = 0, float below = 0);

    void look(ViewSide side);
    void setOrthographic(bool on) { m_state.orthographic = on; }
    void orbit(float pixelsRight, float pixelsDown);
    void pan(float pixelsRight, float pixelsDown);

    /// Factor > 1 comes nearer. What lies in the target's plane under the pixel stays there.
    void zoomAt(float x, float y, float factor);

    Eigen::Matrix4f view() const;
    Eigen::Matrix4f projection() const;
    Vec3f eye() const;
    Vec3f towardsViewer() const; ///< unit, from the target
    Vec3f right() const;
    Vec3f up() const;

    geometry::Ray rayAt(float x, float y) const;

    /// Pixel of a place, and its distance along the view in z.
    Vec3f project(const Vec3f& place) const;

    /// In the target's plane.
    float millimetresPerPixel() const { return 2 * m_state.halfHeight / static_cast<float>(m_height); }

private:
    float distance() const;
    Vec3f planePoint(float x, float y) const;

    CameraState m_state;
    geometry::Bounds m_scene;
    int m_width = 1;
    int m_height = 1;
};

} // namespace knittsim::render
