#include "core/simulation/start_spacings.h"

#include "core/fabric/machine_shape.h"
#include "core/simulation/fabric_cell.h"
#include "core/simulation/simulation.h"

#include <algorithm>

namespace knittsim::simulation {

namespace {

using fabric::Fabric;

constexpr double kNarrowest = 1 / 5.5;   ///< wale spacing to start from, loop lengths
constexpr double kLowest = 1 / 6.5;      ///< course spacing, where the repeat does not tell it
constexpr std::size_t kLargestCell = 16; ///< stitches of a repeat
constexpr int kCellEvaluations = 5'000;
constexpr double kSettleSeconds = 30; ///< for the bonding-point model

/// Wale and course spacing of the fabric's repeat, settled as a periodic cell; nothing where there is none or
/// where it does not settle well.
std::optional<Eigen::Vector2d> cellSpacings(const Fabric& f, std::span<const yarn::Yarn> yarns,
                                            const std::function<bool()>* cancelled) {
    const std::optional<physics::FabricRepeat> found = physics::findFabricRepeat(f);
    if (!found || found->repeat.pattern.faces.size() > kLargestCell) {
        return std::nullopt;
    }
    FabricCellOptions options;
    options.relax.mostEvaluations = kCellEvaluations;
    options.relax.cancelled = cancelled;
    const FabricCell settled = settleCell(f, *found, yarns, options);
    const physics::CellShape& cell = settled.cell;
    if (!physics::isAtRest(cell.relax.verdict) || !cell.faults.empty()) {
        return std::nullopt;
    }
    return settled.units.lengthMm * Eigen::Vector2d(cell.waleSpacing, cell.courseSpacing);
}

} // namespace

Eigen::Vector2d drawIn(const Fabric& f, std::span<const yarn::Yarn> yarns, const YarnLayout& layout) {
    const geometry::Measurement machine = geometry::measure(f, fabric::machinePlaces(f));
    double wale = layout.waleSpacingMm;
    double course = layout.courseSpacingMm;
    const auto isGiven = [&] { return wale > 0 && course > 0; };
    if (const auto cell = isGiven() ? std::nullopt : cellSpacings(f, yarns, layout.cancelled)) {
        wale = cell->x();
        course = cell->y();
    }
    if (!isGiven()) {
        Simulation net;
        net.apply(command::Load{
            .fabric = std::make_shared<Fabric>(f), .yarns = {yarns.begin(), yarns.end()}, .generation = 1});
        net.apply(command::Start{});
        net.advance(1e3 * kSettleSeconds, layout.cancelled);
        const geometry::Measurement rest = geometry::measure(f, net.frame().positions);
        wale = wale > 0 ? wale : rest.waleSpacingMm;
        // The net of bonding points has no thickness; yarn does not come out of so narrow a start.
        course = course > 0 ? course : std::max(rest.courseSpacingMm, kLowest * fabric::meanLoopLength(f));
        wale = wale > 0 ? wale : rest.waleSpacingMm;
    }
    if (!(layout.waleSpacingMm > 0)) {
        wale = std::max(wale, kNarrowest * fabric::meanLoopLength(f));
    }
    const auto factor = [](double to, double from) { return to > 0 && from > 0 ? to / from : 1.0; };
    return {factor(wale, machine.waleSpacingMm), factor(course, machine.courseSpacingMm)};
}

} // namespace knittsim::simulation
