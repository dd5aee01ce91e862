#include "core/physics/yarn_model/chains.h"

#include <algorithm>
#include <cmath>

namespace knittsim::physics {

Vector YarnChains::start() const {
    const Eigen::Index nodeSize = nodes.size();
    Vector x = Vector::Zero(nodeSize + (cell ? 3 : 0));
    x.head(nodeSize) = Eigen::Map<const Vector>(nodes.data(), nodeSize);
    if (cell) {
        x.segment<2>(nodeSize) = *cell;
    }
    return x;
}

const char* YarnChains::problem() const {
    const auto count = static_cast<std::size_t>(nodeCount());
    if (restLength.size() != count || (!restCurvature.empty() && restCurvature.size() != count)) {
        return "as many rest lengths and curvatures as nodes are needed";
    }
    if (!nodes.allFinite() || (cell && !(cell->minCoeff() > 0 && cell->allFinite()))) {
        return "positions and cell must be finite, the cell larger than nothing";
    }
    for (const RodYarn& y : yarns) {
        const bool positive = y.coreDiameter > 0 && y.outerDiameter > y.coreDiameter &&
                              y.axialStiffness > 0 && y.bendingStiffness > 0 && y.contactStiffness >= 0 &&
                              y.friction >= 0 && y.set >= 0 && y.set <= 1;
        if (!positive) {
            return "a yarn's numbers must be positive, its outer diameter larger than its core";
        }
    }
    Entry next = 0;
    for (const Chain& c : chains) {
        if (c.first != next || c.count < (c.closed ? 3 : 2) || c.count > nodeCount() - c.first) {
            return "chains must follow each other and have two nodes, closed ones three";
        }
        if (c.yarn < 0 || static_cast<std::size_t>(c.yarn) >= yarns.size()) {
            return "a chain names a yarn that is not there";
        }
        if ((c.across != 0 || c.up != 0) && !(c.closed && cell)) {
            return "only closed chains of a cell lead to an image";
        }
        for (Entry i = 0; i < c.segmentCount(); ++i) {
            const double length = restLength[static_cast<std::size_t>(c.first + i)];
            if (!(length > 0) || !std::isfinite(length)) {
                return "rest lengths must be positive";
            }
        }
        next = c.first + c.count;
    }
    return next == nodeCount() ? "" : "every node must belong to a chain";
}

double thickestYarn(const std::vector<RodYarn>& yarns) {
    double largest = 0;
    for (const RodYarn& y : yarns) {
        largest = std::max(largest, y.outerDiameter);
    }
    return largest;
}

std::vector<double> arcLengths(const YarnChains& chains) {
    std::vector<double> arc(static_cast<std::size_t>(chains.nodeCount()), 0);
    for (const Chain& c : chains.chains) {
        for (Entry i = 1; i < c.count; ++i) {
            const auto node = static_cast<std::size_t>(c.first + i);
            arc[node] = arc[node - 1] + chains.restLength[node - 1];
        }
    }
    return arc;
}

std::vector<double> nodeLengths(const YarnChains& chains) {
    std::vector<double> share(static_cast<std::size_t>(chains.nodeCount()), 0);
    for (const Chain& c : chains.chains) {
        for (Entry i = 0; i < c.segmentCount(); ++i) {
            const double half = 0.5 * chains.restLength[static_cast<std::size_t>(c.first + i)];
            share[static_cast<std::size_t>(c.place(i).node)] += half;
            share[static_cast<std::size_t>(c.place(i + 1).node)] += half;
        }
    }
    return share;
}

} // namespace knittsim::physics
