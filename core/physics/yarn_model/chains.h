#pragma once

#include "core/physics/energy_term.h"

#include <Eigen/Core>

#include <cstdint>
#include <optional>
#include <vector>

/// Input of the yarn model as plain values, whoever made the curve.
///
/// Units: lengths in outer diameters d of a reference yarn, stiffness in its bending stiffness EI; so
/// energies in EI/d and forces in EI/d^2. One set of numbers then serves every yarn (yarn_units.h converts).
namespace knittsim::physics {

/// What the model knows of a yarn (PHYSICS-REFERENCE 2.4).
struct RodYarn {
    double outerDiameter = 1;      ///< where contact begins: the hull of the fibres
    double coreDiameter = 0.5;     ///< packed fibres; the repulsion grows without bound towards it
    double axialStiffness = 1000;  ///< EA
    double bendingStiffness = 1;   ///< EI
    double contactStiffness = 0.1; ///< k of the kernel, EI/d^5
    double friction = 0;           ///< mu, yarn on yarn
    double set = 0;                ///< share of its curvature it keeps when it takes set, 0 to 1
};

/// A node or its image: `across` cell widths to the right and `up` cell heights above.
struct Place {
    Entry node = 0;
    int across = 0;
    int up = 0;

    Place shifted(int right, int above) const { return {node, across + right, up + above}; }
    bool isImage() const { return across != 0 || up != 0; }
    bool operator==(const Place&) const = default;
};

/// Nodes [first, first + count) along one piece of yarn. A closed chain goes on at the image of its first
/// node that lies `across` and `up` cells away (a course of a periodic fabric: across = 1).
struct Chain {
    Entry first = 0;
    Entry count = 0;
    int yarn = 0; ///< into YarnChains::yarns
    bool closed = false;
    int across = 0;
    int up = 0;

    Entry segmentCount() const { return closed ? count : count - 1; }

    /// The i-th node, i from -1 to count for closed chains.
    Place place(Entry i) const {
        if (i < 0) {
            return {first + i + count, -across, -up};
        }
        return i < count ? Place{first + i, 0, 0} : Place{first + i - count, across, up};
    }
};

/// All yarns of a fabric. With `cell` it repeats itself with that width (x) and height (y); both are then
/// unknowns, kept as one more entry (width, height, 0) behind the nodes.
struct YarnChains {
    std::vector<RodYarn> yarns;
    std::vector<Chain> chains;
    Eigen::Matrix3Xd nodes;         ///< positions at the start
    std::vector<double> restLength; ///< by node: yarn to the next node; not used at the end of an open chain
    std::vector<double> restCurvature; ///< by node, 1/d; empty: straight yarn
    std::optional<Eigen::Vector2d> cell;

    Entry nodeCount() const { return static_cast<Entry>(nodes.cols()); }
    /// The entry of the cell, -1 without one.
    Entry cellEntry() const { return cell ? nodeCount() : -1; }

    /// Start as a vector of entries: nodes, then the cell.
    Vector start() const;

    /// Empty when all is well; else what is wrong: indices out of range, lengths that are not positive.
    const char* problem() const;
};

/// Largest outer diameter.
double thickestYarn(const std::vector<RodYarn>& yarns);

/// Arc length at each node, from the start of its chain.
std::vector<double> arcLengths(const YarnChains& chains);

/// Half the yarn to the node before and half the yarn to the node after: the node's share of the yarn.
std::vector<double> nodeLengths(const YarnChains& chains);

/// Where a place is at x.
inline Eigen::Vector3d position(const Vector& x, Entry cell, const Place& p) {
    Eigen::Vector3d result = at(x, p.node);
    if (p.isImage()) {
        const auto size = at(x, cell);
        result.x() += p.across * size.x();
        result.y() += p.up * size.y();
    }
    return result;
}

/// Adds what belongs to a place: to its node and, for an image, to the cell.
inline void addAt(Vector& v, Entry cell, const Place& p, const Eigen::Vector3d& value) {
    at(v, p.node) += value;
    if (p.isImage()) {
        auto size = at(v, cell);
        size.x() += p.across * value.x();
        size.y() += p.up * value.y();
    }
}

} // namespace knittsim::physics
