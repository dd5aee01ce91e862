#pragma once

#include "core/base/vec3.h"

namespace knittsim::geometry {

/// The unit direction across a yarn (of unit `tangent`) that is nearest to `before`. Carried on from node to
/// node it turns with the yarn as little as it can.
inline Vec3f carryAcross(const Vec3f& before, const Vec3f& tangent) {
    const Vec3f across = before - before.dot(tangent) * tangent;
    const float length = across.norm();
    return length > 1e-3F ? Vec3f(across / length) : Vec3f(tangent.unitOrthogonal());
}

} // namespace knittsim::geometry
