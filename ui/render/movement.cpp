#include "ui/render/movement.h"

namespace knittsim::render {

std::vector<float> movementOfPoints(const fabric::Fabric& fabric, std::span<const float> now,
                                    std::span<const float> before) {
    const std::size_t expected = 3 * static_cast<std::size_t>(fabric.entryCount);
    std::vector<float> moved;
    if (now.size() != expected || before.size() != expected) {
        return moved;
    }
    moved.reserve(fabric.points.size());
    for (const fabric::BondingPoint& point : fabric.points) {
        const std::size_t e = 3 * static_cast<std::size_t>(point.entry);
        const auto place = [e](std::span<const float> shape) {
            return Vec3f(shape[e], shape[e + 1], shape[e + 2]);
        };
        moved.push_back((place(now) - place(before)).norm());
    }
    return moved;
}

std::vector<float> movementOfNodes(const geometry::YarnCurves& now, const geometry::YarnCurves& before) {
    std::vector<float> moved;
    if (now.nodes.size() == before.nodes.size()) {
        moved.reserve(now.nodes.size());
        for (std::size_t i = 0; i < now.nodes.size(); ++i) {
            moved.push_back((now.nodes[i] - before.nodes[i]).norm());
        }
    }
    return moved;
}

} // namespace knittsim::render
