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

bool Skin::isStale(const Vector& x) const {
    if (m_reference.size() != x.size() || !x.allFinite()) {
        return true;
    }
    if (m_cell < 0) {
        return false;
    }
    const double moved = relativeMotionBound(m_reference, x, m_nodeCount, m_cell, m_range + m_thickness);
    return !(moved < m_thickness);
}

Skin::Age Skin::renew(const Vector& x, double range) {
    constexpr Entry kMany = 3; // a third of the nodes: then all at once is quicker
    Age age = isStale(x) ? Age::Stale : Age::Fresh;
    if (age == Age::Fresh && m_cell < 0) {
        m_moved.assign(static_cast<std::size_t>(m_nodeCount), 0);
        Entry count = 0;
        for (Entry e = 0; e < m_nodeCount; ++e) {
            if ((at(x, e) - at(m_reference, e)).squaredNorm() > 0.25 * m_thickness * m_thickness) {
                m_moved[static_cast<std::size_t>(e)] = 1;
                ++count;
            }
        }
        age = count == 0 ? Age::Fresh : kMany * count < m_nodeCount ? Age::Partly : Age::Stale;
    }
    if (age == Age::Stale) {
        m_reference = x;
        m_range = range;
    } else if (age == Age::Partly) {
        for (Entry e = 0; e < m_nodeCount; ++e) {
            if (moved(e)) {
                at(m_reference, e) = at(x, e);
            }
        }
    }
    return age;
}

} // namespace knittsim::physics
