#include "app/cli/relax_periodic.h"

#include "app/cli/commands.h"
#include "app/cli/verdict_text.h"
#include "core/physics/yarn_model/fabric_repeat.h"
#include "core/physics/yarn_model/relax_cell.h"
#include "core/physics/yarn_model/yarn_units.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <chrono>
#include <limits>

namespace knittsim::cli {

namespace {

using physics::CellShape;
using physics::FabricRepeat;

nlohmann::ordered_json report(const Loaded& loaded, const FabricRepeat& found, const CellShape& cell,
                              const physics::YarnUnits& units, const std::string& integrator,
                              double wallSeconds) {
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
            {"energy_uj", cell.relax.energy * units.energyMicroJoule()},
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
    fmt::print("  {} core overlaps, {} stitches whose topology is in doubt\n", r["penetrations"].get<int>(),
               r["topology_faults"].get<int>());
}

} // namespace

int relaxPeriodic(const Loaded& loaded, const PeriodicOptions& options) {
    const std::optional<FabricRepeat> found = physics::findFabricRepeat(*loaded.fabric);
    if (!found) {
        fmt::print(stderr, "--periodic: most of the fabric would have to be knit and purl stitches of one "
                           "yarn that repeat themselves\n");
        return kUnusable;
    }
    const yarn::Yarn& material = loaded.yarns[found->carrier];
    const physics::YarnUnits units = physics::unitsOf(material);
    std::vector<double> lengths = found->repeat.loopLengths;
    for (double& length : lengths) {
        length /= units.lengthMm;
    }

    const auto start = std::chrono::steady_clock::now();
    const auto seconds = [&] {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    };
    const std::function<bool()> late = [&] { return seconds() > options.maxSeconds; };
    physics::CellOptions cellOptions;
    cellOptions.relax.residual = options.until;
    cellOptions.relax.cancelled = &late;
    cellOptions.relax.mostEvaluations = std::numeric_limits<int>::max(); // time is the limit
    if (!options.integrator.empty()) {
        cellOptions.relax.integrator = options.integrator.c_str();
    }
    const CellShape cell =
        physics::relaxCell(found->repeat.pattern, lengths, physics::toRod(material, units), cellOptions);
    const nlohmann::ordered_json result =
        report(loaded, *found, cell, units, cellOptions.relax.integrator, seconds());
    if (options.json) {
        fmt::print("{}\n", result.dump(2));
    } else {
        printText(result);
    }
    const bool sound =
        result["converged"].get<bool>() && cell.relax.audit.coreOverlaps == 0 && cell.faults.empty();
    return sound ? kFine : kProblems;
}

} // namespace knittsim::cli
