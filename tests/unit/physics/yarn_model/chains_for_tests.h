#pragma once

#include "core/physics/yarn_model/chains.h"

#include <cmath>
#include <random>
#include <vector>

namespace knittsim::physics::test {

inline double uniform(std::mt19937& random, double low, double high) {
    return low + (high - low) * static_cast<double>(random()) / static_cast<double>(std::mt19937::max());
}

/// Adds an open chain through the points; its rest lengths are `slack` times its present ones.
inline void addChain(YarnChains& chains, const std::vector<Eigen::Vector3d>& points, int yarn = 0,
                     double slack = 1) {
    const Entry first = chains.nodeCount();
    const auto count = static_cast<Entry>(points.size());
    chains.nodes.conservativeResize(3, first + count);
    for (Entry i = 0; i < count; ++i) {
        const auto k = static_cast<std::size_t>(i);
        chains.nodes.col(first + i) = points[k];
        chains.restLength.push_back(i + 1 < count ? slack * (points[k + 1] - points[k]).norm() : 0.0);
    }
    chains.chains.push_back({first, count, yarn, false, 0, 0});
}

/// Makes the last chain a closed one that goes on `across` and `up` cells away.
inline void closeLast(YarnChains& chains, int across, int up, double rest) {
    Chain& chain = chains.chains.back();
    chain.closed = true;
    chain.across = across;
    chain.up = up;
    chains.restLength[static_cast<std::size_t>(chain.first + chain.count - 1)] = rest;
}

/// Straight yarn of `count` nodes from one point to another.
inline std::vector<Eigen::Vector3d> line(const Eigen::Vector3d& from, const Eigen::Vector3d& to, int count) {
    std::vector<Eigen::Vector3d> points;
    for (int i = 0; i < count; ++i) {
        points.push_back(from + (to - from) * (static_cast<double>(i) / (count - 1)));
    }
    return points;
}

/// Two crossing yarns of unlike thickness, bent and unevenly spaced; `gap` between their middles.
inline YarnChains twoYarns(unsigned seed, double slack, double gap) {
    std::mt19937 random(seed);
    YarnChains chains;
    chains.yarns = {{1, 0.5, 50, 1, 0.1}, {1.2, 0.7, 80, 2, 0.3}};
    const auto shaken = [&](std::vector<Eigen::Vector3d> points) {
        for (Eigen::Vector3d& p : points) {
            p += Eigen::Vector3d(uniform(random, -0.1, 0.1), uniform(random, -0.1, 0.1),
                                 uniform(random, -0.05, 0.05));
        }
        return points;
    };
    addChain(chains, shaken(line({-1, 0, 0}, {1, 0.3, 0}, 6)), 0, slack);
    addChain(chains, shaken(line({0.2, -1, gap}, {-0.1, 1, gap}, 6)), 1, slack);
    return chains;
}

/// One wavy closed course in a cell so low that it touches its own image above.
inline YarnChains course(unsigned seed, double slack) {
    std::mt19937 random(seed);
    YarnChains chains;
    chains.yarns = {{1, 0.5, 50, 1, 0.1}};
    std::vector<Eigen::Vector3d> points;
    constexpr int kCount = 8;
    for (int i = 0; i < kCount; ++i) {
        const double t = 2 * 3.14159265358979 * i / kCount;
        points.emplace_back(0.4 * i, 0.8 * std::sin(t), 0.4 * std::cos(t) + uniform(random, -0.05, 0.05));
    }
    addChain(chains, points, 0, slack);
    closeLast(chains, 1, 0, 0.6 * slack);
    chains.cell = Eigen::Vector2d(0.4 * kCount, 0.9);
    return chains;
}

} // namespace knittsim::physics::test
