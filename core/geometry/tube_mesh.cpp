#include "core/geometry/tube_mesh.h"

#include "core/geometry/yarn_frame.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace knittsim::geometry {

namespace {

constexpr float kNearestMm = 1e-5F;
constexpr float kDome = std::numbers::sqrt2_v<float> / 2; ///< sine and cosine of its one ring

std::vector<Vec3f> distinct(std::span<const Vec3f> nodes) {
    std::vector<Vec3f> kept;
    kept.reserve(nodes.size());
    for (const Vec3f& node : nodes) {
        if (node.allFinite() && (kept.empty() || (node - kept.back()).norm() > kNearestMm)) {
            kept.push_back(node);
        }
    }
    return kept;
}

Vec3f tangentAt(std::span<const Vec3f> nodes, std::size_t n) {
    const std::size_t last = nodes.size() - 1;
    const Vec3f before = n > 0 ? Vec3f((nodes[n] - nodes[n - 1]).normalized()) : Vec3f(Vec3f::Zero());
    const Vec3f after = n < last ? Vec3f((nodes[n + 1] - nodes[n]).normalized()) : Vec3f(Vec3f::Zero());
    const Vec3f both = before + after;
    return both.norm() > 1e-3F ? Vec3f(both.normalized()) : after; // where the yarn turns back on itself
}

float distanceToSegment(const Vec3f& p, const Vec3f& a, const Vec3f& b) {
    const Vec3f way = b - a;
    const float square = way.squaredNorm();
    const float share = square > 0 ? std::clamp((p - a).dot(way) / square, 0.0F, 1.0F) : 0;
    return (a + share * way - p).norm();
}

class Weaver {
public:
    Weaver(float radius, int sides) : m_radius(radius) {
        for (int k = 0; k < sides; ++k) {
            const float angle =
                2 * std::numbers::pi_v<float> * static_cast<float>(k) / static_cast<float>(sides);
            m_circle.emplace_back(std::cos(angle), std::sin(angle));
        }
    }

    /// `lean`: sine of the angle of the normals to the cross-section, along the tangent.
    void ring(const Vec3f& centre, const Vec3f& tangent, const Vec3f& across, float lean) {
        const Vec3f up = tangent.cross(across);
        const float reach = std::sqrt(1 - lean * lean);
        for (const auto& [c, s] : m_circle) {
            const Vec3f normal = (reach * (c * across + s * up) + lean * tangent).normalized();
            mesh.places.emplace_back(centre + m_radius * normal);
            mesh.normals.push_back(normal);
        }
    }

    void pole(const Vec3f& centre, const Vec3f& outwards) {
        mesh.places.emplace_back(centre + m_radius * outwards);
        mesh.normals.push_back(outwards);
    }

    void join(std::size_t rings) {
        const auto sides = static_cast<std::uint32_t>(m_circle.size());
        const auto last = static_cast<std::uint32_t>(mesh.places.size()) - 1;
        const auto lastRing = last - sides;
        const auto add = [this](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
            mesh.triangles.insert(mesh.triangles.end(), {a, b, c});
        };
        mesh.triangles.reserve(6 * sides * rings);
        for (std::uint32_t k = 0; k < sides; ++k) {
            const std::uint32_t next = (k + 1) % sides;
            add(0, 1 + next, 1 + k);
            for (std::uint32_t r = 0; r + 1 < rings; ++r) {
                const std::uint32_t low = 1 + r * sides;
                const std::uint32_t high = low + sides;
                add(low + k, low + next, high + next);
                add(low + k, high + next, high + k);
            }
            add(last, lastRing + k, lastRing + next);
        }
    }

    TubeMesh mesh;

private:
    float m_radius;
    std::vector<std::pair<float, float>> m_circle; ///< cosine, sine
};

} // namespace

std::vector<Vec3f> thinned(std::span<const Vec3f> nodes, float toleranceMm) {
    constexpr std::size_t kMostSkipped = 16; // keeps this linear; longer straight yarn is rare
    std::vector<Vec3f> kept;
    for (std::size_t at = 0; at < nodes.size();) {
        kept.push_back(nodes[at]);
        std::size_t next = at + 1;
        const auto reaches = [&](std::size_t to) {
            for (std::size_t n = at + 1; n < to; ++n) {
                if (!(distanceToSegment(nodes[n], nodes[at], nodes[to]) <= toleranceMm)) {
                    return false;
                }
            }
            return true;
        };
        while (next + 1 < nodes.size() && next - at < kMostSkipped && reaches(next + 1)) {
            ++next;
        }
        at = next;
    }
    return kept;
}

TubeMesh makeTube(std::span<const Vec3f> given, float radiusMm, int sides) {
    const std::vector<Vec3f> nodes = distinct(given);
    if (nodes.size() < 2) {
        return {};
    }
    Weaver weaver(radiusMm, std::max(3, sides));
    const std::size_t count = (nodes.size() + 2) * static_cast<std::size_t>(std::max(3, sides)) + 2;
    weaver.mesh.places.reserve(count);
    weaver.mesh.normals.reserve(count);
    Vec3f tangent = tangentAt(nodes, 0);
    Vec3f across = tangent.unitOrthogonal();
    weaver.pole(nodes.front(), -tangent);
    weaver.ring(nodes.front(), tangent, across, -kDome);
    for (std::size_t n = 0; n < nodes.size(); ++n) {
        tangent = tangentAt(nodes, n);
        across = carryAcross(across, tangent);
        weaver.ring(nodes[n], tangent, across, 0);
    }
    weaver.ring(nodes.back(), tangent, across, kDome);
    weaver.pole(nodes.back(), tangent);
    weaver.join(nodes.size() + 2);
    return std::move(weaver.mesh);
}

} // namespace knittsim::geometry
