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

/// Says what of a list of near pairs has to be found anew. The pairs nearer than range + thickness are
/// listed, judged by the places of reference; the list holds while no other pair can have come within the
/// range. Without a cell each node has a reference of its own, so that where only some nodes run about, only
/// their pairs are looked for.
class Skin {
public:
    Skin(Entry nodeCount, Entry cell, double thickness)
        : m_nodeCount(nodeCount), m_cell(cell), m_thickness(thickness) {}

    Entry nodeCount() const { return m_nodeCount; }
    double thickness() const { return m_thickness; }
    void forget() { m_reference.resize(0); }

    enum class Age { Fresh, Partly, Stale };

    /// Partly: the pairs of the nodes that have moved() are to be found anew, Stale: all pairs. The reference
    /// follows; `range` from now on.
    Age renew(const Vector& x, double range);

    const Vector& reference() const { return m_reference; }
    bool moved(Entry node) const { return m_moved[static_cast<std::size_t>(node)] != 0; }

private:
    bool isStale(const Vector& x) const;

    Entry m_nodeCount;
    Entry m_cell;
    double m_thickness;
    double m_range = 0;
    Vector m_reference;
    std::vector<char> m_moved; ///< by node, at the last renew
};

} // namespace knittsim::physics
