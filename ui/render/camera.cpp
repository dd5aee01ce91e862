#include "ui/render/camera.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace knittsim::render {

namespace {

constexpr float kHalfPi = std::numbers::pi_v<float> / 2;
constexpr float kRadiansPerPixel = 0.008F;
constexpr float kFitMargin = 1.06F;
constexpr float kTanHalfFieldOfView = 0.2F; // long lens: stitches at the edge are seen nearly straight on
constexpr float kNearest = 0.02F;           // mm, half height
constexpr float kFarthest = 1e5F;

float finiteOr(float value, float fallback) {
    return std::isfinite(value) ? value : fallback;
}

} // namespace

void Camera::setState(const CameraState& state) {
    m_state.target = state.target.allFinite() ? state.target : Vec3f(Vec3f::Zero());
    m_state.yaw = std::remainder(finiteOr(state.yaw, 0), 4 * kHalfPi);
    m_state.pitch = std::clamp(finiteOr(state.pitch, 0), -kHalfPi, kHalfPi);
    m_state.halfHeight = std::clamp(finiteOr(state.halfHeight, 50), kNearest, kFarthest);
    m_state.orthographic = state.orthographic;
}

void Camera::setViewport(int width, int height) {
    m_width = std::max(1, width);
    m_height = std::max(1, height);
}

void Camera::fit(const geometry::Bounds& box, float above, float below) {
    if (box.empty()) {
        return;
    }
    const Vec3f half = 0.5F * box.size();
    const auto reach = [&](const Vec3f& axis) { return axis.cwiseAbs().dot(half); };
    const float aspect = static_cast<float>(m_width) / static_cast<float>(m_height);
    const auto pixels = static_cast<float>(m_height);
    const float share = std::max(0.2F, 1 - (above + below) / pixels);
    float halfHeight = std::max(reach(up()) / share, reach(right()) / aspect);
    if (!m_state.orthographic) {
        halfHeight += kTanHalfFieldOfView * reach(towardsViewer());
    }
    m_state.halfHeight = std::clamp(kFitMargin * halfHeight, kNearest, kFarthest);
    m_state.target = box.centre() + (above - below) / pixels * m_state.halfHeight * up();
}

void Camera::look(ViewSide side) {
    m_state.yaw = 0;
    m_state.pitch = 0;
    switch (side) {
    case ViewSide::Front:
        break;
    case ViewSide::Back:
        m_state.yaw = 2 * kHalfPi;
        break;
    case ViewSide::Right:
        m_state.yaw = kHalfPi;
        break;
    case ViewSide::Left:
        m_state.yaw = -kHalfPi;
        break;
    case ViewSide::Top:
        m_state.pitch = kHalfPi;
        break;
    case ViewSide::Bottom:
        m_state.pitch = -kHalfPi;
        break;
    }
}

void Camera::orbit(float pixelsRight, float pixelsDown) {
    CameraState next = m_state;
    next.yaw -= kRadiansPerPixel * pixelsRight;
    next.pitch += kRadiansPerPixel * pixelsDown;
    setState(next);
}

void Camera::pan(float pixelsRight, float pixelsDown) {
    m_state.target += millimetresPerPixel() * (pixelsDown * up() - pixelsRight * right());
}

void Camera::zoomAt(float x, float y, float factor) {
    if (!(factor > 0) || !std::isfinite(factor)) {
        return;
    }
    const Vec3f before = planePoint(x, y);
    m_state.halfHeight = std::clamp(m_state.halfHeight / factor, kNearest, kFarthest);
    m_state.target += before - planePoint(x, y);
}

Vec3f Camera::towardsViewer() const {
    return {std::sin(m_state.yaw) * std::cos(m_state.pitch), std::sin(m_state.pitch),
            std::cos(m_state.yaw) * std::cos(m_state.pitch)};
}

Vec3f Camera::right() const {
    return {std::cos(m_state.yaw), 0, -std::sin(m_state.yaw)};
}

Vec3f Camera::up() const {
    return towardsViewer().cross(right());
}

float Camera::distance() const {
    return m_state.halfHeight / kTanHalfFieldOfView;
}

Vec3f Camera::eye() const {
    return m_state.target + distance() * towardsViewer();
}

Eigen::Matrix4f Camera::view() const {
    Eigen::Matrix4f matrix = Eigen::Matrix4f::Identity();
    matrix.block<1, 3>(0, 0) = right().transpose();
    matrix.block<1, 3>(1, 0) = up().transpose();
    matrix.block<1, 3>(2, 0) = towardsViewer().transpose();
    matrix.block<3, 1>(0, 3) = -(matrix.block<3, 3>(0, 0) * eye());
    return matrix;
}

Eigen::Matrix4f Camera::projection() const {
    // Depth range: the sphere around the scene, and always a little about the target.
    float radius = 2 * m_state.halfHeight;
    if (!m_scene.empty()) {
        radius = std::max(radius, (m_scene.centre() - m_state.target).norm() + 0.5F * m_scene.size().norm());
    }
    radius *= 1.01F;
    const float aspect = static_cast<float>(m_width) / static_cast<float>(m_height);
    const float h = m_state.halfHeight;
    const float d = distance();
    Eigen::Matrix4f matrix = Eigen::Matrix4f::Zero();
    if (m_state.orthographic) {
        matrix(0, 0) = 1 / (h * aspect);
        matrix(1, 1) = 1 / h;
        matrix(2, 2) = -1 / radius;
        matrix(2, 3) = -d / radius;
        matrix(3, 3) = 1;
        return matrix;
    }
    const float near = std::max(d - radius, 0.02F * d);
    const float far = d + radius;
    matrix(0, 0) = 1 / (kTanHalfFieldOfView * aspect);
    matrix(1, 1) = 1 / kTanHalfFieldOfView;
    matrix(2, 2) = -(far + near) / (far - near);
    matrix(2, 3) = -2 * far * near / (far - near);
    matrix(3, 2) = -1;
    return matrix;
}

Vec3f Camera::planePoint(float x, float y) const {
    const float perPixel = millimetresPerPixel();
    return m_state.target + perPixel * ((x - 0.5F * static_cast<float>(m_width)) * right() -
                                        (y - 0.5F * static_cast<float>(m_height)) * up());
}

geometry::Ray Camera::rayAt(float x, float y) const {
    const Vec3f through = planePoint(x, y);
    if (m_state.orthographic) {
        // From far enough before the scene, whatever its depth.
        const float back = distance() + (m_scene.empty() ? 0 : m_scene.size().norm());
        return {through + back * towardsViewer(), -towardsViewer()};
    }
    return {eye(), (through - eye()).normalized()};
}

Vec3f Camera::project(const Vec3f& place) const {
    const Vec3f offset = place - m_state.target;
    const float towards = offset.dot(towardsViewer());
    const float scale =
        m_state.orthographic ? 1 : distance() / std::max(distance() - towards, 1e-3F * distance());
    const float perPixel = millimetresPerPixel();
    return {0.5F * static_cast<float>(m_width) + scale * offset.dot(right()) / perPixel,
            0.5F * static_cast<float>(m_height) - scale * offset.dot(up()) / perPixel, towards};
}

} // namespace knittsim::render
