#include "core/simulation/fabric_yarns.h"

#include <algorithm>
#include <cmath>

/// What a shape of the chains shows.
namespace knittsim::simulation {

namespace {

using fabric::Fabric;
using fabric::PointIndex;
using geometry::YarnCurves;
using physics::Entry;

constexpr float kDeepest = 1.1F; ///< diameters, for shading

} // namespace

YarnCurves curvesOf(const FabricYarns& yarns, const physics::Vector& x) {
    YarnCurves curves;
    const auto nodes = static_cast<std::size_t>(yarns.chains.nodeCount());
    curves.nodes.reserve(nodes);
    curves.arc.reserve(nodes);
    curves.point = yarns.point;
    curves.piece = yarns.piece;
    for (std::size_t c = 0; c < yarns.chains.chains.size(); ++c) {
        const physics::Chain& chain = yarns.chains.chains[c];
        curves.yarns.push_back({chain.first, chain.count, yarns.carrier[c]});
        double arc = 0;
        for (Entry e = chain.first; e < chain.first + chain.count; ++e) {
            const Eigen::Vector3d place = yarns.units.lengthMm * physics::at(x, e);
            arc += e == chain.first
                       ? 0
                       : yarns.units.lengthMm * (physics::at(x, e) - physics::at(x, e - 1)).norm();
            curves.nodes.push_back(place.cast<float>());
            curves.arc.push_back(static_cast<float>(arc));
            curves.normal.emplace_back(0.0F, 0.0F, 1.0F);
        }
    }
    // What lies deep is dark; a thick fabric is not black for that.
    float most = 0;
    for (const Vec3f& node : curves.nodes) {
        most = std::max(most, std::abs(node.z()));
    }
    const float deepest = kDeepest * static_cast<float>(yarns.units.lengthMm);
    const float share = most > deepest ? deepest / most : 1;
    for (const Vec3f& node : curves.nodes) {
        curves.height.push_back(share * node.z());
    }
    return curves;
}

std::vector<float> entryPositions(const Fabric& f, const FabricYarns& yarns, const physics::Vector& x) {
    std::vector<float> positions;
    positions.reserve(3 * static_cast<std::size_t>(f.entryCount));
    for (fabric::EntryIndex entry = 0; entry < f.entryCount; ++entry) {
        Eigen::Vector3d sum = Eigen::Vector3d::Zero();
        int count = 0;
        for (const PointIndex p : f.at(entry)) {
            const Entry node = yarns.nodeOfPoint[static_cast<std::size_t>(p)];
            if (node >= 0) {
                sum += physics::at(x, node);
                ++count;
            }
        }
        const Eigen::Vector3d place = yarns.units.lengthMm / std::max(1, count) * sum;
        for (Eigen::Index i = 0; i < 3; ++i) {
            positions.push_back(static_cast<float>(place[i]));
        }
    }
    return positions;
}

} // namespace knittsim::simulation
