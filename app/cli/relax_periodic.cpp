#include "app/cli/relax_periodic.h"

#include "app/cli/commands.h"
#include "app/cli/verdict_text.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

namespace knittsim::cli {

namespace {

using physics::CellShape;

nlohmann::ordered_json report(const Loaded& loaded, const simulation::FabricCell& settled,
                              const std::string& integrator, double wallSeconds) {
    const auto& [found, units, rod, cell] = settled;
    const physics::KnitPurl& pattern = found.repeat.pattern;
    const physics::StopRule::Verdict verdict = cell.relax.verdict;
    const double mm = units.lengthMm;
    return {{"file", loaded.timeline->program().file},
            {"model", "yarn"},
            {"periodic", true},
            {"integrator", integrator},
            {"converged", isAtRest(verdict)},
            {"reason", verdictText(verdict)},
            {"residual", cell.relax.residual},
            {"steps", cell.relax.steps},
            {"evaluations", cell.relax.evaluations},
            {"wall_seconds", wallSeconds},
            {"repeat_wales", pattern.wales},
            {"repeat_courses", pattern.courses},
            {"width_mm", pattern.wales * cell.waleSpacing * mm},
            {"height_mm", pattern.courses * cell.courseSpacing * mm},
            {"wale_spacing_mm", cell.waleSpacing * mm},
            {"course_spacing_mm", cell.courseSpacing * mm},
            {"thickness_mm", cell.thickness * mm},
            {"loop_length_mm", cell.loopLength * mm},
            {"yarn_diameter_mm", mm},
            {"friction", rod.friction},
            {"set", rod.set},
            {"energy_uj", cell.energy * units.energyMicroJoule()},
            {"penetrations", cell.relax.audit.coreOverlaps},
            {"max_penetration_mm", cell.relax.audit.deepestOverlap * mm},
            {"topology_faults", cell.faults.size()}};
}

void printText(const nlohmann::ordered_json& r) {
    const auto number = [&](const char* key) { return r[key].get<double>(); };
    fmt::print("{}: a repeat of {} wales x {} courses\n", r["file"].get<std::string>(),
               r["repeat_wales"].get<int>(), r["repeat_courses"].get<int>());
    fmt::print("  {} after {} steps of {}: {} (residual {:.2e}, {:.3f} s)\n",
               r["converged"].get<bool>() ? "at rest" : "not at rest", r["steps"].get<int>(),
               r["integrator"].get<std::string>(), r["reason"].get<std::string>(), number("residual"),
               number("wall_seconds"));
    fmt::print(
        "  wale spacing {:.3f} mm, course spacing {:.3f} mm, thickness {:.2f} mm, loop length {:.2f} mm\n",
        number("wale_spacing_mm"), number("course_spacing_mm"), number("thickness_mm"),
        number("loop_length_mm"));
    fmt::print("  friction {:.2f}, set {:.2f}\n", number("friction"), number("set"));
    fmt::print("  {} core overlaps, {} stitches whose topology is in doubt\n", r["penetrations"].get<int>(),
               r["topology_faults"].get<int>());
}

} // namespace

int relaxPeriodic(const Loaded& loaded, const PeriodicOptions& options, bool json) {
    const Deadline deadline(options.maxSeconds);
    const std::optional<simulation::FabricCell> settled = settlePeriodic(loaded, options, deadline);
    if (!settled) {
        return kUnusable;
    }
    const nlohmann::ordered_json result =
        report(loaded, *settled, relaxOptions(options, deadline).integrator, deadline.seconds());
    if (json) {
        fmt::print("{}\n", result.dump(2));
    } else {
        printText(result);
    }
    const CellShape& cell = settled->cell;
    const bool sound =
        result["converged"].get<bool>() && cell.relax.audit.coreOverlaps == 0 && cell.faults.empty();
    return sound ? kFine : kProblems;
}

} // namespace knittsim::cli
