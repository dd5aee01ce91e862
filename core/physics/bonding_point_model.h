#pragma once

#include "core/fabric/fabric.h"
#include "core/physics/model.h"
#include "core/physics/model_options.h"
#include "core/physics/rope_term.h"
#include "core/yarn/yarn.h"

#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace knittsim::physics {

/// The bonding-point model of a fabric (PHYSICS 1).
struct BondingPointModel {
    std::unique_ptr<Model> model;
    const RopeTerm* ropes = nullptr; ///< part of the model

    /// By spring: the bonding point where its yarn segment begins.
    std::vector<fabric::PointIndex> springPoint;
    /// By rope: its first and last bonding point.
    std::vector<std::pair<fabric::PointIndex, fabric::PointIndex>> ropePoints;

    /// Force in the yarn from each bonding point to the next one, mN, > 0 pulls; 0 where no yarn follows.
    void tensions(const Vector& x, std::span<float> byPoint) const;
};

/// `yarns` by carrier; carriers beyond its end get a default yarn. Linear in the number of bonding points.
BondingPointModel buildBondingPointModel(const fabric::Fabric& fabric, std::span<const yarn::Yarn> yarns,
                                         const ModelOptions& options = {});

/// The machine's positions as unknowns, 3 per entry.
Vector machinePositions(const fabric::Fabric& fabric);

} // namespace knittsim::physics
