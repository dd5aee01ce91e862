#include "core/export/shape.h"

#include "core/fabric/machine_shape.h"
#include "core/geometry/yarn_curve_builder.h"

#include <algorithm>

namespace knittsim::exports {

namespace {

constexpr int kMostRounds = 8; ///< of ordering strands; nearly all fabrics need two
constexpr std::size_t kManyLoops = 5000;

std::vector<Material> materialsOf(const fabric::Fabric& fabric, std::span<const yarn::Yarn> yarns) {
    std::vector<Material> materials;
    for (const yarn::Yarn& yarn : yarns) {
        materials.push_back({yarn.name, yarn.colour, yarn.outerDiameterMm});
    }
    for (const fabric::Yarn& yarn : fabric.yarns) {
        materials.resize(std::max<std::size_t>(materials.size(), std::size_t{yarn.carrier} + 1));
    }
    return materials;
}

/// Nodes [first, last) as a yarn of its own.
void addPiece(geometry::YarnCurves& part, const geometry::YarnCurves& whole, std::int32_t first,
              std::int32_t last, machine::CarrierIndex carrier) {
    part.yarns.push_back({static_cast<std::int32_t>(part.nodes.size()), last - first, carrier});
    const auto copy = [&](const auto& from, auto& to) {
        if (!from.empty()) {
            to.insert(to.end(), from.begin() + first, from.begin() + last);
        }
    };
    const auto begin = static_cast<std::ptrdiff_t>(part.arc.size());
    copy(whole.nodes, part.nodes);
    copy(whole.point, part.point);
    copy(whole.piece, part.piece);
    copy(whole.arc, part.arc);
    copy(whole.normal, part.normal);
    copy(whole.height, part.height);
    const float start = whole.arc[static_cast<std::size_t>(first)];
    std::for_each(part.arc.begin() + begin, part.arc.end(), [start](float& arc) { arc -= start; });
}

} // namespace

std::optional<Shape> shapeAt(std::shared_ptr<const fabric::Fabric> fabric, std::span<const yarn::Yarn> yarns,
                             std::vector<float> places, const Progress& progress) {
    const std::vector<float> machine = fabric::machinePlaces(*fabric);
    std::vector<Material> materials = materialsOf(*fabric, yarns);
    std::vector<double> diameters;
    for (const Material& material : materials) {
        diameters.push_back(material.diameterMm);
    }
    const int samples = fabric->loops.size() > kManyLoops ? 3 : 4;
    geometry::YarnCurveBuilder builder(*fabric, diameters, {.samplesPerSegment = samples});
    for (int round = 0; round < kMostRounds; ++round) {
        if (progress && !progress(static_cast<double>(round) / kMostRounds)) {
            return std::nullopt;
        }
        if (builder.orderStrands(*fabric, machine) == 0) {
            break;
        }
    }
    if (places.empty()) {
        places = machine;
    }
    builder.update(places);
    return Shape{std::move(fabric), builder.curves(), std::move(places), std::move(materials), {}};
}

Shape shapeOf(std::shared_ptr<const fabric::Fabric> fabric, std::span<const yarn::Yarn> yarns,
              geometry::YarnCurves curves, std::vector<float> places) {
    std::vector<Material> materials = materialsOf(*fabric, yarns);
    return Shape{std::move(fabric), std::move(curves), std::move(places), std::move(materials), {}};
}

Shape partOf(Shape shape, const std::vector<bool>& keep) {
    if (keep.empty()) {
        return shape;
    }
    geometry::YarnCurves part;
    for (const geometry::YarnCurves::Range& yarn : shape.curves.yarns) {
        const std::int32_t end = yarn.first + yarn.count;
        const auto wanted = [&](std::int32_t node) {
            const auto point = static_cast<std::size_t>(shape.curves.point[static_cast<std::size_t>(node)]);
            return point < keep.size() && keep[point];
        };
        for (std::int32_t first = yarn.first; first < end;) {
            std::int32_t last = first;
            while (last < end && wanted(last)) {
                ++last;
            }
            // The yarn goes on to the next node, which may belong to a point that is not wanted.
            const std::int32_t to = last > first ? std::min(last + 1, end) : last;
            if (to > first + 1) {
                addPiece(part, shape.curves, first, to, yarn.carrier);
            }
            first = last + 1;
        }
    }
    shape.curves = std::move(part);
    shape.keep = keep;
    shape.keep.resize(shape.fabric->points.size(), false);
    return shape;
}

} // namespace knittsim::exports
