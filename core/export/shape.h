#pragma once

#include "core/base/progress.h"
#include "core/fabric/fabric.h"
#include "core/geometry/yarn_curve.h"
#include "core/yarn/yarn.h"

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace knittsim::exports {

/// A yarn as far as a file can say what it is.
struct Material {
    std::string name; ///< of the yarn
    yarn::Colour colour;
    double diameterMm = 0.36; ///< of the hull
};

/// A fabric in one shape.
struct Shape {
    std::shared_ptr<const fabric::Fabric> fabric;
    geometry::YarnCurves curves;
    std::vector<float> places;       ///< of the bonding points: 3 per entry, mm
    std::vector<Material> materials; ///< by carrier, for every carrier of `curves`
    std::vector<bool> keep{};        ///< by bonding point: those that `curves` shows; empty: all
};

/// The shape with the bonding points at `places` (empty: where the machine leaves them), with curves whose
/// crossings are as the fabric's books say wherever they can be. `yarns` by carrier; missing ones get a
/// default yarn. Nothing when `progress` ended it.
std::optional<Shape> shapeAt(std::shared_ptr<const fabric::Fabric> fabric, std::span<const yarn::Yarn> yarns,
                             std::vector<float> places, const Progress& progress = {});

/// The shape with curves that somebody else has made of this fabric, and the places of its bonding points.
Shape shapeOf(std::shared_ptr<const fabric::Fabric> fabric, std::span<const yarn::Yarn> yarns,
              geometry::YarnCurves curves, std::vector<float> places);

/// The parts of a shape whose bonding points are wanted, each as a yarn of its own. `keep` by bonding point;
/// empty: all.
Shape partOf(Shape shape, const std::vector<bool>& keep);

} // namespace knittsim::exports
