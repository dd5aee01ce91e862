#pragma once

#include "core/physics/yarn_model/chains.h"

#include <optional>

namespace knittsim::physics {

/// Bound on how far two points (of nodes, segments and their images) that are at most `distance` apart move
/// against each other from one shape to another. What all have in common does not count: a shift, and the
/// stretch of the cell but for its part of `distance`.
double relativeMotionBound(const Vector& from, const Vector& to, Entry nodeCount, Entry cell,
                           double distance);

/// Width and height of the cell at x; nothing without one.
std::optional<Eigen::Vector2d> cellAt(const Vector& x, Entry cell);

/// Says when a list of near pairs has to be found anew. The pairs nearer than range + thickness are listed;
/// the list holds while no other pair can have come within the range.
class Skin {
public:
    Skin(Entry nodeCount, Entry cell, double thickness)
        : m_nodeCount(nodeCount), m_cell(cell), m_thickness(thickness) {}

    double thickness() const { return m_thickness; }
    void forget() { m_reference.resize(0); }
    bool outOfDate(const Vector& x) const;

    /// Pairs have been found for x.
    void renew(const Vector& x, double range) {
        m_reference = x;
        m_range = range;
    }

private:
    Entry m_nodeCount;
    Entry m_cell;
    double m_thickness;
    double m_range = 0;
    Vector m_reference;
};

} // namespace knittsim::physics
