#include "core/physics/yarn_model/skin.h"

#include <algorithm>
#include <cmath>

namespace knittsim::physics {

double relativeMotionBound(const Vector& from, const Vector& to, Entry nodeCount, Entry cell,
                           double distance) {
    Eigen::Array3d stretch = Eigen::Array3d::Ones();
    if (cell >= 0) {
        stretch.head<2>() = at(to, cell).array().head<2>() / at(from, cell).array().head<2>();
    }
    const auto own = [&](Entry e) -> Eigen::Vector3d {
        return at(to, e).array() - stretch * at(from, e).array();
    };
    Eigen::Vector3d shift = Eigen::Vector3d::Zero();
    for (Entry e = 0; e < nodeCount; ++e) {
        shift += own(e);
    }
    shift /= std::max(1, nodeCount);
    double largest = 0;
    for (Entry e = 0; e < nodeCount; ++e) {
        largest = std::max(largest, (own(e) - shift).squaredNorm());
    }
    return 2 * std::sqrt(largest) + (stretch - 1).abs().maxCoeff() * distance;
}

std::optional<Eigen::Vector2d> cellAt(const Vector& x, Entry cell) {
    if (cell < 0) {
        return std::nullopt;
    }
    return Eigen::Vector2d(at(x, cell).head<2>());
}

bool Skin::outOfDate(const Vector& x) const {
    if (m_reference.size() != x.size()) {
        return true;
    }
    const double moved = relativeMotionBound(m_reference, x, m_nodeCount, m_cell, m_range + m_thickness);
    return !(moved < m_thickness); // also when x is not a number
}

} // namespace knittsim::physics
