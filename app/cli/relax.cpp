#include "app/cli/commands.h"
#include "app/cli/load.h"
#include "app/cli/relax_fabric.h"
#include "app/cli/relax_periodic.h"
#include "core/geometry/measure.h"
#include "core/simulation/simulation.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <chrono>
#include <cstdio>
#include <map>
#include <memory>

namespace knittsim::cli {

namespace {

struct RelaxOptions {
    LoadOptions load;
    std::string model = "bonding-points";
    std::string integrator;
    std::string region;
    std::string state;
    double until = 1e-3;
    double maxSeconds = 60;
    bool json = false;
    bool periodic = false;
    std::optional<double> friction;
    double set = 0;
    std::string surroundings;
};

/// "W0:W1,C0:C1". Returns what is wrong, or an empty string.
std::string parseRegion(const std::string& text, geometry::Region& region) {
    int used = 0;
    const int read = std::sscanf(text.c_str(), "%d:%d,%d:%d%n", &region.firstWale, &region.lastWale,
                                 &region.firstCourse, &region.lastCourse, &used);
    const bool ordered = region.firstWale <= region.lastWale && region.firstCourse <= region.lastCourse;
    const bool whole = read == 4 && static_cast<std::size_t>(used) == text.size();
    return whole && ordered && region.firstWale >= 0 && region.firstCourse >= 0
               ? std::string()
               : "expected W0:W1,C0:C1 with W0 <= W1 and C0 <= C1, for example 5:24,5:34";
}

const char* reasonText(simulation::StopReason reason) {
    using enum simulation::StopReason;
    switch (reason) {
    case ResidualReached:
        return "residual reached";
    case Stagnation:
        return "shape and energy no longer change";
    case StepLimit:
        return "step limit";
    case Diverged:
        return "diverged";
    case SolverFailed:
        return "solver failed";
    default:
        return "time limit";
    }
}

/// Everything measured on the settled fabric; keys as in the documentation of the command line.
nlohmann::ordered_json report(const Loaded& loaded, const simulation::Frame& frame,
                              const geometry::Measurement& size, double wallSeconds,
                              const std::string& model) {
    std::map<std::string, double> yarnLength;
    double mass = 0;
    double diameter = 0;
    double length = 0;
    for (const fabric::Yarn& yarn : loaded.fabric->yarns) {
        const yarn::Yarn& material = loaded.yarns[yarn.carrier];
        yarnLength[loaded.timeline->program().header.carriers[yarn.carrier].name] += yarn.lengthMm;
        mass += yarn.lengthMm * material.tex * 1e-6;
        diameter += yarn.lengthMm * material.outerDiameterMm;
        length += yarn.lengthMm;
    }
    using simulation::StopReason;
    const bool converged =
        frame.reason == StopReason::ResidualReached || frame.reason == StopReason::Stagnation;
    return {{"file", loaded.timeline->program().file},
            {"model", model},
            {"integrator", frame.integrator},
            {"converged", converged},
            {"reason", reasonText(frame.reason)},
            {"residual", frame.residual},
            {"steps", frame.step},
            {"wall_seconds", wallSeconds},
            {"width_mm", size.widthMm},
            {"height_mm", size.heightMm},
            {"wale_spacing_mm", size.waleSpacingMm},
            {"course_spacing_mm", size.courseSpacingMm},
            {"wales", size.wales},
            {"courses", size.courses},
            {"loop_length_mm", size.loopLengthMm},
            {"yarn_diameter_mm", length > 0 ? diameter / length : 0},
            {"mass_g", mass},
            {"potential_energy_uj", frame.energies.potential},
            {"loops", loaded.fabric->loops.size() - loaded.removedLoops},
            {"removed_loops", loaded.removedLoops},
            {"bonding_points", loaded.fabric->points.size()},
            {"table_entries", loaded.fabric->entryCount},
            {"crossings", loaded.fabric->crossings.size()},
            {"yarn_length_mm", yarnLength}};
}

void printText(const nlohmann::ordered_json& r) {
    const auto number = [&](const char* key) { return r[key].get<double>(); };
    fmt::print("{}\n", r["file"].get<std::string>());
    fmt::print("  {} after {} steps of {}: {} (residual {:.2e}, {:.2f} s)\n",
               r["converged"].get<bool>() ? "at rest" : "not at rest", r["steps"].get<long>(),
               r["integrator"].get<std::string>(), r["reason"].get<std::string>(), number("residual"),
               number("wall_seconds"));
    fmt::print("  {:.1f} x {:.1f} mm, {} wales x {} courses\n", number("width_mm"), number("height_mm"),
               r["wales"].get<int>(), r["courses"].get<int>());
    fmt::print("  wale spacing {:.3f} mm, course spacing {:.3f} mm, loop length {:.2f} mm, mass {:.2f} g\n",
               number("wale_spacing_mm"), number("course_spacing_mm"), number("loop_length_mm"),
               number("mass_g"));
    if (r["removed_loops"].get<std::size_t>() > 0) {
        fmt::print("  {} loops have run and were taken out\n", r["removed_loops"].get<std::size_t>());
    }
}

int runRelax(const RelaxOptions& options) {
    if (options.model != "yarn" && (options.periodic || !options.surroundings.empty())) {
        fmt::print(stderr, "--periodic and --surroundings need --model yarn\n");
        return kUnusable;
    }
    if (options.periodic &&
        !(options.region.empty() && options.state.empty() && options.surroundings.empty())) {
        fmt::print(stderr, "--region, --surroundings and -o are for whole fabrics, not for --periodic\n");
        return kUnusable;
    }
    if (!options.periodic && (options.friction || options.set > 0)) {
        fmt::print(stderr, "--friction and --set are for --periodic\n");
        return kUnusable;
    }
    std::optional<geometry::Region> region;
    if (!options.region.empty()) {
        if (const std::string problem = parseRegion(options.region, region.emplace()); !problem.empty()) {
            fmt::print(stderr, "--region '{}': {}\n", options.region, problem);
            return kUnusable;
        }
    }
    const auto loaded = load(options.load);
    if (!loaded) {
        return kUnusable;
    }
    if (options.periodic) {
        return relaxPeriodic(
            *loaded, {options.integrator, options.until, options.maxSeconds, options.friction, options.set},
            options.json);
    }
    if (options.model == "yarn") {
        return relaxFabric(*loaded, {options.integrator, options.state, options.until, options.maxSeconds,
                                     region, surroundingsOf(options.surroundings), options.json});
    }
    simulation::Simulation simulation;
    if (!options.integrator.empty()) {
        simulation.apply(simulation::command::SetIntegrator{options.integrator});
    }
    simulation.apply(simulation::command::SetResidual{options.until});
    simulation.apply(
        simulation::command::Load{.fabric = loaded->fabric, .yarns = loaded->yarns, .generation = 1});
    simulation.apply(simulation::command::Start{});
    const auto start = std::chrono::steady_clock::now();
    simulation.runToEnd(options.maxSeconds);
    const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
    const simulation::Frame frame = simulation.frame();
    const geometry::Measurement size =
        geometry::measure(*loaded->fabric, frame.positions, region.value_or(geometry::Region()));
    const nlohmann::ordered_json result = report(*loaded, frame, size, wall.count(), options.model);
    if (options.json) {
        fmt::print("{}\n", result.dump(2));
    } else {
        printText(result);
    }
    if (!options.state.empty() && !writeState(options.state, *loaded, frame.positions)) {
        return kUnusable;
    }
    return result["converged"].get<bool>() ? kFine : kProblems;
}

} // namespace

void addRelax(CLI::App& app, Command& chosen) {
    auto options = std::make_shared<RelaxOptions>();
    CLI::App* command = app.add_subcommand("relax", "Let the fabric settle and measure it");
    command->add_option("file", options->load.file, "machine file")->required();
    command->add_option("--model", options->model, "what settles")
        ->check(CLI::IsMember({"bonding-points", "yarn"}))
        ->capture_default_str();
    std::vector<std::string> ids;
    for (const simulation::IntegratorInfo& info : simulation::integrators()) {
        ids.emplace_back(info.id);
    }
    command->add_option("--integrator", options->integrator, "solver; the fastest when not given")
        ->check(CLI::IsMember(ids));
    command->add_option("--yarn", options->load.yarns, "CARRIER=ID: yarn of a carrier, from the library");
    command->add_option("--loop-length", options->load.loopLengthMm, "MM of yarn in every loop")
        ->check(CLI::Range(0.1, 200.0));
    addReduction(*command, options->load);
    command->add_option("--until", options->until, "relative residual to reach")
        ->check(CLI::Range(1e-12, 1.0))
        ->capture_default_str();
    command->add_option("--max-seconds", options->maxSeconds, "time limit")
        ->check(CLI::Range(0.0, 1e6))
        ->capture_default_str();
    command->add_option("--region", options->region, "W0:W1,C0:C1: wales and courses to measure, from 0");
    command->add_flag("--periodic", options->periodic, "settle one repeat of the pattern (--model yarn)");
    addYarnPhysics(*command, options->friction, options->set);
    addSurroundings(*command, options->surroundings);
    command->add_flag("--json", options->json, "print JSON");
    command->add_option("-o", options->state, "write the settled shape (JSON)");
    command->callback([&chosen, options] { chosen = [options] { return runRelax(*options); }; });
}

} // namespace knittsim::cli
