#pragma once

#include "core/fabric/fabric.h"
#include "core/physics/yarn_model/fabric_repeat.h"
#include "core/physics/yarn_model/pull_test.h"
#include "core/physics/yarn_model/yarn_units.h"
#include "core/yarn/yarn.h"

#include <optional>
#include <span>
#include <string>

namespace knittsim::simulation {

/// The repeat of a fabric, settled as a periodic cell of the yarn model; in the units of its yarn.
struct FabricCell {
    physics::FabricRepeat found;
    physics::YarnUnits units;
    physics::RodYarn rod;
    physics::CellShape cell;
};

struct FabricCellOptions {
    std::optional<double> friction; ///< instead of the yarn's; 0: the cell settles without a history
    double set = 0;                 ///< share of its curvature that the yarn keeps
    int nodesPerLoop = 24;
    physics::YarnRelaxOptions relax;
};

/// Taut yarn turns sharply: with 24 nodes a loop plain fabric locks a tenth too early, with 36 no more.
constexpr int kPullNodesPerLoop = 36;

/// Settles what findFabricRepeat() has found, off the fabric's machine. `yarns` by carrier; carriers beyond
/// the end get a default yarn.
FabricCell settleCell(const fabric::Fabric& fabric, const physics::FabricRepeat& found,
                      std::span<const yarn::Yarn> yarns, const FabricCellOptions& options);

/// N/mm in one unit of a pull test.
double stressUnit(const physics::YarnUnits& units);

/// A header and one line a point: strain, stress N/mm, width and height of the repeat mm, on the way back.
std::string pullCsv(std::span<const physics::PullPoint> points, const physics::YarnUnits& units);

} // namespace knittsim::simulation
