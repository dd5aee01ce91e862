#pragma once

#include <array>

namespace knittsim::geometry {

/// Weights of four neighbouring control points of the uniform cubic B-spline at t in [0, 1).
inline std::array<float, 4> splineWeights(float t) {
    const float u = 1 - t;
    return {u * u * u / 6, (3 * t * t * t - 6 * t * t + 4) / 6, (3 * u * u * u - 6 * u * u + 4) / 6,
            t * t * t / 6};
}

} // namespace knittsim::geometry
