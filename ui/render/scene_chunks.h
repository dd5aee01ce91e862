#pragma once

#include "ui/render/fabric_scene.h"

#include <functional>

namespace knittsim::render {

/// Cuts the yarns of a frame into chunks; fills chunks, segmentMm and bounds from nodes and topology.
void addChunks(SceneFrame& frame);

/// Between two yarns; shaders know it by its arc length.
constexpr std::array<float, 4> kNoNode{0, 0, 0, -1};

/// First place from `node` on that every stride meets.
constexpr std::int32_t alignedNode(std::int32_t node) {
    return (node + kMostStride - 1) / kMostStride * kMostStride;
}

/// The parts of a frame whose bonding points are wanted, each as a yarn of its own. Keeps the bounds of the
/// whole, so that the camera and the dimensions stay. `keep` by bonding point.
std::shared_ptr<const SceneFrame> isolated(const SceneFrame& whole, const fabric::Fabric& fabric,
                                           const std::vector<bool>& keep);

} // namespace knittsim::render
