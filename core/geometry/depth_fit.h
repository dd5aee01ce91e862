#pragma once

#include "core/geometry/yarn_curve.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace knittsim::geometry {

/// Gives pieces of uniform cubic B-splines a length by moving control points in depth (along z) only: the
/// projection along z stays and with it all crossings. A piece that is too short waves to the front and back,
/// one that is too long is drawn flat, both as far as the strands that it crosses leave it room. The
/// constraints are met one after the other, again and again (Mueller et al., Position Based Dynamics, 2007).
class DepthFit {
public:
    /// Control points [firstControl, firstControl + count), between two that mirror the ends; every one but
    /// the last begins `weights.size()` nodes, from firstNode on.
    struct Spline {
        std::int32_t firstControl = 0;
        std::int32_t count = 0;
        std::int32_t firstNode = 0;
    };

    /// Two strands that cross, `share` of the way from a node to the next one.
    struct Order {
        std::int32_t front = 0;
        std::int32_t behind = 0;
        float frontShare = 0;
        float behindShare = 0;
        float leastMm = 0; ///< of depth between them
    };

    /// `weights` of the control points around a place, by node between two control points.
    DepthFit(std::vector<Spline> splines, std::span<const std::array<float, 4>> weights,
             std::span<const Vec3f> nodes);

    /// `tolerance` relative to the length. Orders are met before lengths.
    void run(std::span<const YarnPiece> pieces, std::span<const Order> orders, float tolerance);

    const std::vector<Vec3f>& nodes() const { return m_nodes; }

private:
    struct Place {
        std::int32_t control = 0; ///< before it
        std::int32_t sample = 0;
        const Spline* spline = nullptr;
    };
    Place placeOf(std::int32_t node) const;
    bool stretch(const YarnPiece& piece, float tolerance);
    bool hasMoved(std::int32_t firstNode, std::int32_t lastNode, std::uint64_t seen) const;
    bool part(const Order& order);
    bool canBeAsLong(const YarnPiece& piece) const;
    void push(std::int32_t node, float share, float by);
    void move(const Spline& spline, std::int32_t control, float by);

    std::vector<Spline> m_splines;
    std::vector<std::array<float, 4>> m_weights;
    std::vector<Vec3f> m_nodes;
    std::vector<std::uint64_t> m_movedAt; ///< by control point, moves until then
    std::uint64_t m_clock = 1;            ///< moves so far
    std::vector<float> m_slope;           ///< of the length of the piece at hand, by its control points
};

} // namespace knittsim::geometry
