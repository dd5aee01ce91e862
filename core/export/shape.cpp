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
    return Shape{std::move(fabric), builder.curves(), std::move(places), std::move(materials)};
}

Shape shapeOf(std::shared_ptr<const fabric::Fabric> fabric, std::span<const yarn::Yarn> yarns,
              geometry::YarnCurves curves, std::vector<float> places) {
    std::vector<Material> materials = materialsOf(*fabric, yarns);
    return Shape{std::move(fabric), std::move(curves), std::move(places), std::move(materials)};
}

} // namespace knittsim::exports
