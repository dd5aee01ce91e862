#include "ui/render/scene_chunks.h"

#include "ui/render/hidden_sky.h"

#include <algorithm>

namespace knittsim::render {

namespace {

constexpr std::int32_t kChunkNodes = 128; // a multiple of kMostStride

/// A run of nodes of a yarn that are all wanted.
void copyRun(const SceneFrame& whole, std::size_t first, std::size_t last, machine::CarrierIndex carrier,
             SceneFrame& part, SceneTopology& topology) {
    // At least one place between two runs tells the shaders that they do not go on.
    const auto to = static_cast<std::size_t>(alignedNode(static_cast<std::int32_t>(part.nodes.size()) + 1));
    part.nodes.resize(to, kNoNode);
    part.surface.resize(to);
    topology.owner.resize(to, 0);
    const auto copy = [&](const auto& from, auto& into) {
        into.insert(into.end(), from.begin() + static_cast<std::ptrdiff_t>(first),
                    from.begin() + static_cast<std::ptrdiff_t>(last));
    };
    copy(whole.nodes, part.nodes);
    copy(whole.surface, part.surface);
    copy(whole.topology->owner, topology.owner);
    topology.yarns.push_back(
        {static_cast<std::int32_t>(to), static_cast<std::int32_t>(last - first), carrier});
}

} // namespace

void addChunks(SceneFrame& frame) {
    double arc = 0;
    const auto placeOf = [&](std::int32_t n) {
        return Vec3f::Map(frame.nodes[static_cast<std::size_t>(n)].data());
    };
    for (const geometry::YarnCurves::Range& yarn : frame.topology->yarns) {
        const std::int32_t last = yarn.first + yarn.count - 1;
        arc += static_cast<double>(frame.nodes[static_cast<std::size_t>(last)][3]);
        for (std::int32_t first = yarn.first; first < last; first += kChunkNodes) {
            Chunk chunk{first, std::min(kChunkNodes + 1, last - first + 1), yarn.carrier, {}, 0};
            geometry::Bounds box;
            for (std::int32_t n = first; n < first + chunk.count; ++n) {
                box.add(placeOf(n));
            }
            chunk.centre = box.centre();
            chunk.reach = 0.5F * box.size().norm();
            const float radius = 0.5F * frame.diameters[yarn.carrier];
            frame.bounds.add(box.low.array() - radius);
            frame.bounds.add(box.high.array() + radius);
            frame.chunks.push_back(chunk);
        }
    }
    frame.segmentMm =
        static_cast<float>(arc / static_cast<double>(std::max<std::size_t>(1, frame.nodes.size())));
}

std::shared_ptr<const SceneFrame> isolated(const SceneFrame& whole, const fabric::Fabric& fabric,
                                           const std::vector<bool>& keep) {
    auto part = std::make_shared<SceneFrame>();
    auto topology = std::make_shared<SceneTopology>();
    topology->loopOfPoint = whole.topology->loopOfPoint;
    topology->pointCount = whole.topology->pointCount;
    const auto wanted = [&](std::size_t node) {
        const std::size_t point = whole.topology->owner[node];
        return point < keep.size() && keep[point];
    };
    for (const geometry::YarnCurves::Range& yarn : whole.topology->yarns) {
        const auto end = static_cast<std::size_t>(yarn.first + yarn.count);
        for (auto first = static_cast<std::size_t>(yarn.first); first < end;) {
            auto last = first;
            while (last < end && wanted(last)) {
                ++last;
            }
            // The yarn goes on to the next node, which may belong to a point that is not wanted.
            const std::size_t to = last > first ? std::min(last + 1, end) : last;
            if (to > first + 1) {
                copyRun(whole, first, to, yarn.carrier, *part, *topology);
            }
            first = last + 1;
        }
    }
    part->topology = std::move(topology);
    part->style = whole.style;
    part->diameters = whole.diameters;
    addHidden(*part);
    addChunks(*part);
    part->segmentMm = whole.segmentMm;
    part->bounds = whole.bounds;
    for (std::size_t entry = 0; entry < whole.markers.size(); ++entry) {
        const auto points = fabric.at(static_cast<fabric::EntryIndex>(entry));
        if (std::ranges::any_of(points,
                                [&](fabric::PointIndex p) { return keep[static_cast<std::size_t>(p)]; })) {
            part->markers.push_back(whole.markers[entry]);
        }
    }
    return part;
}

} // namespace knittsim::render
