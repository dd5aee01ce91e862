#include "app/cli/commands.h"
#include "app/cli/periodic_cell.h"
#include "core/base/file.h"
#include "core/base/message_table.h"
#include "core/physics/yarn_model/pull_test.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <memory>

namespace knittsim::cli {

namespace {

using physics::PullPoint;
using physics::PullResult;

struct PullCommandOptions {
    LoadOptions load;
    PeriodicOptions periodic;
    std::string axis = "courses";
    double strain = 0.6;
    int steps = 20;
    std::string csv;
    bool json = false;
};

nlohmann::ordered_json toJson(const PullCommandOptions& options, const simulation::FabricCell& settled,
                              const PullResult& result, double wallSeconds) {
    const double stress = simulation::stressUnit(settled.units);
    nlohmann::ordered_json points = nlohmann::ordered_json::array();
    for (const PullPoint& p : result.points) {
        points.push_back({{"strain", p.strain},
                          {"stress_n_per_mm", p.stress * stress},
                          {"width_mm", p.width * settled.units.lengthMm},
                          {"height_mm", p.height * settled.units.lengthMm},
                          {"back", p.back}});
    }
    return {{"file", options.load.file},
            {"axis", options.axis},
            {"repeat_wales", settled.found.repeat.pattern.wales},
            {"repeat_courses", settled.found.repeat.pattern.courses},
            {"friction", settled.rod.friction},
            {"set", settled.rod.set},
            {"converged", physics::isAtRest(result.verdict)},
            {"wall_seconds", wallSeconds},
            {"penetrations", result.audit.coreOverlaps},
            {"topology_faults", result.faults.size()},
            {"work_n_per_mm", result.work(false) * stress},
            {"work_back_n_per_mm", result.work(true) * stress},
            {"points", points}};
}

void printText(const nlohmann::ordered_json& r) {
    const auto number = [](const nlohmann::ordered_json& from, const char* key) {
        return from[key].get<double>();
    };
    fmt::print("{}: a repeat of {} wales x {} courses, drawn along {}, friction {:.2f}\n",
               r["file"].get<std::string>(), r["repeat_wales"].get<int>(), r["repeat_courses"].get<int>(),
               r["axis"].get<std::string>(), number(r, "friction"));
    fmt::print("      strain    N/mm  width mm  height mm\n");
    for (const auto& p : r["points"]) {
        fmt::print("  {:4} {:5.3f} {:7.4f} {:9.3f} {:10.3f}\n", p["back"].get<bool>() ? "back" : "",
                   number(p, "strain"), number(p, "stress_n_per_mm"), number(p, "width_mm"),
                   number(p, "height_mm"));
    }
    const double work = number(r, "work_n_per_mm");
    fmt::print(
        "  given back {:.0f} % of the work; {} core overlaps, {} stitches whose topology is in doubt\n",
        work > 0 ? 100 * number(r, "work_back_n_per_mm") / work : 0, r["penetrations"].get<int>(),
        r["topology_faults"].get<int>());
    if (!r["converged"].get<bool>()) {
        fmt::print("  the last step did not come to rest\n");
    }
}

bool writeCsv(const std::string& path, const std::string& text) {
    const auto written = writeFileAtomically(path, text);
    for (const Diagnostic& diagnostic : written.diagnostics()) {
        fmt::print(stderr, "{}\n", toLine(diagnostic));
    }
    return written.hasValue();
}

int runPull(const PullCommandOptions& options) {
    const auto loaded = load(options.load);
    if (!loaded) {
        return kUnusable;
    }
    const Deadline deadline(options.periodic.maxSeconds);
    const auto settled = settlePeriodic(*loaded, options.periodic, deadline, simulation::kPullNodesPerLoop);
    if (!settled) {
        return kUnusable;
    }
    if (!physics::isAtRest(settled->cell.relax.verdict)) {
        fmt::print(stderr, "the repeat did not come to rest before it was drawn\n");
        return kProblems;
    }
    physics::PullOptions pull;
    pull.side = options.axis == "courses" ? physics::CellLoadTerm::Width : physics::CellLoadTerm::Height;
    pull.strain = options.strain;
    pull.steps = options.steps;
    pull.relax = relaxOptions(options.periodic, deadline);
    const PullResult result = physics::pullCell(settled->found.repeat.pattern, settled->cell, pull);
    const nlohmann::ordered_json report = toJson(options, *settled, result, deadline.seconds());
    if (options.json) {
        fmt::print("{}\n", report.dump(2));
    } else {
        printText(report);
    }
    if (!options.csv.empty() && !writeCsv(options.csv, simulation::pullCsv(result.points, settled->units))) {
        return kUnusable;
    }
    const bool sound =
        physics::isAtRest(result.verdict) && result.audit.coreOverlaps == 0 && result.faults.empty();
    return sound ? kFine : kProblems;
}

} // namespace

void addPull(CLI::App& app, Command& chosen) {
    auto options = std::make_shared<PullCommandOptions>();
    CLI::App* command =
        app.add_subcommand("pull", "Draw one repeat of knit and purl longer and back, in the yarn model");
    command->add_option("file", options->load.file, "machine file")->required();
    command->add_option("--axis", options->axis, "direction of the pull")
        ->check(CLI::IsMember({"wales", "courses"}))
        ->capture_default_str();
    command->add_option("--strain", options->strain, "largest strain")
        ->check(CLI::Range(1e-4, 10.0))
        ->capture_default_str();
    command->add_option("--steps", options->steps, "up to it, and as many back")
        ->check(CLI::Range(1, 10'000))
        ->capture_default_str();
    command->add_option("--yarn", options->load.yarns, "CARRIER=ID: yarn of a carrier, from the library");
    command->add_option("--loop-length", options->load.loopLengthMm, "MM of yarn in every loop")
        ->check(CLI::Range(0.1, 200.0));
    addYarnPhysics(*command, options->periodic.friction, options->periodic.set);
    command->add_option("--until", options->periodic.until, "relative residual to reach")
        ->check(CLI::Range(1e-12, 1.0))
        ->capture_default_str();
    command->add_option("--max-seconds", options->periodic.maxSeconds, "time limit")
        ->check(CLI::Range(0.0, 1e6))
        ->capture_default_str();
    command->add_option("--csv", options->csv, "write the points (CSV)");
    command->add_flag("--json", options->json, "print JSON");
    command->callback([&chosen, options] { chosen = [options] { return runPull(*options); }; });
}

} // namespace knittsim::cli
