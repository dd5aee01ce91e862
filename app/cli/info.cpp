#include "app/cli/commands.h"
#include "app/cli/load.h"
#include "core/export/report.h"
#include "core/fabric/fabric_builder.h"
#include "core/fabric/reduction.h"
#include "core/geometry/curve_report.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <map>
#include <memory>

namespace knittsim::cli {

namespace {

struct InfoOptions {
    LoadOptions load;
    bool json = false;
    bool curves = false;
};

nlohmann::ordered_json summarise(const machine::Timeline& timeline, const fabric::Fabric& fabric) {
    const machine::Program& program = timeline.program();
    nlohmann::ordered_json operations = nlohmann::ordered_json::object();
    std::array<int, machine::kOperationKindCount> counts{};
    for (const machine::Operation& op : program.operations) {
        ++counts[static_cast<std::size_t>(op.kind)];
    }
    for (std::size_t kind = 0; kind < counts.size(); ++kind) {
        if (counts[kind] > 0) {
            operations[machine::toString(static_cast<machine::OperationKind>(kind))] = counts[kind];
        }
    }
    std::map<std::string, double> yarnLength;
    nlohmann::ordered_json carriers = nlohmann::ordered_json::array();
    for (const machine::Carrier& carrier : program.header.carriers) {
        carriers.push_back(carrier.name);
    }
    for (const fabric::Yarn& yarn : fabric.yarns) {
        yarnLength[program.header.carriers[yarn.carrier].name] += yarn.lengthMm;
    }
    const exports::Totals totals = exports::countTotals(program, fabric);
    return {{"file", program.file},
            {"operations", totals.operations},
            {"operations_by_kind", operations},
            {"carriers", carriers},
            {"needles", totals.needles},
            {"front_needles", totals.frontNeedles},
            {"rear_needles", totals.rearNeedles},
            {"courses", totals.courses},
            {"loops", totals.loops},
            {"bonding_points", fabric.points.size()},
            {"table_entries", fabric.entryCount},
            {"crossings", fabric.crossings.size()},
            {"unstable_loops", fabric::findRuns(fabric).loopCount()},
            {"yarn_length_mm", yarnLength},
            {"problems", timeline.diagnostics().size()}};
}

/// How exact the yarn curves are on the machine, drawn as thin as the hard cores of the yarns of `relax`.
nlohmann::ordered_json inspect(const Loaded& loaded) {
    std::vector<double> diameters;
    for (const yarn::Yarn& yarn : loaded.yarns) {
        diameters.push_back(yarn.coreDiameterMm);
    }
    const geometry::YarnCurves curves = geometry::buildMachineCurves(*loaded.fabric, diameters);
    const geometry::CurveReport report = geometry::inspectCurves(*loaded.fabric, curves, diameters);
    return {{"crossings_expected", report.crossings.expected},
            {"crossings_found", report.crossings.found},
            {"crossing_faults", report.crossings.faults.size()},
            {"stitches", report.certificate.pairs},
            {"pull_throughs", report.certificate.failures.size()},
            {"smallest_distance_mm", report.nearest.mm},
            {"pieces_too_far", report.piecesTooFar},
            {"pieces", report.pieces},
            {"pieces_as_stored", report.piecesAsStored},
            {"pieces_out_of_reach", report.piecesOutOfReach}};
}

void printText(const nlohmann::ordered_json& info) {
    const auto list = [](const nlohmann::ordered_json& object, const char* unit) {
        std::string text;
        for (const auto& [key, value] : object.items()) {
            const std::string shown =
                value.is_number_float() ? fmt::format("{:.0f}", value.get<double>()) : value.dump();
            text += fmt::format("{}{} {}{}", text.empty() ? "" : ", ", key, shown, unit);
        }
        return text;
    };
    std::string carriers;
    for (const auto& name : info["carriers"]) {
        carriers += (carriers.empty() ? "" : " ") + name.get<std::string>();
    }
    fmt::print("{}\n", info["file"].get<std::string>());
    fmt::print("  operations      {} ({})\n", info["operations"].dump(),
               list(info["operations_by_kind"], ""));
    fmt::print("  carriers        {}\n", carriers);
    fmt::print("  needles         {} (front {}, rear {})\n", info["needles"].dump(),
               info["front_needles"].dump(), info["rear_needles"].dump());
    for (const char* key :
         {"courses", "loops", "bonding_points", "table_entries", "crossings", "unstable_loops"}) {
        std::string name = key;
        std::ranges::replace(name, '_', ' ');
        fmt::print("  {:<16}{}\n", name, info[key].dump());
    }
    fmt::print("  yarn by carrier {}\n", list(info["yarn_length_mm"], " mm"));
    if (info.contains("curves")) {
        const auto& curves = info["curves"];
        fmt::print(
            "  yarn curves     {} of {} crossings as recorded, {} faults; {} stitches, {} pull-throughs\n",
            curves["crossings_found"].dump(), curves["crossings_expected"].dump(),
            curves["crossing_faults"].dump(), curves["stitches"].dump(), curves["pull_throughs"].dump());
        fmt::print("                  strands {:.3f} mm apart or more\n",
                   curves["smallest_distance_mm"].get<double>());
        fmt::print(
            "                  {} of {} pieces as long as their yarn, {} cannot be; ends of {} more lie "
            "too far apart\n",
            curves["pieces_as_stored"].dump(), curves["pieces"].dump(), curves["pieces_out_of_reach"].dump(),
            curves["pieces_too_far"].dump());
    }
}

int runInfo(const InfoOptions& options) {
    Loaded loaded;
    if (options.curves) {
        auto all = load(options.load);
        if (!all) {
            return kUnusable;
        }
        loaded = std::move(*all);
    } else if ((loaded.timeline = loadTimeline(options.load)) != nullptr) {
        loaded.fabric = std::make_shared<fabric::Fabric>(fabric::buildFabric(*loaded.timeline));
    } else {
        return kUnusable;
    }
    const machine::Timeline* timeline = loaded.timeline.get();
    nlohmann::ordered_json info = summarise(*timeline, *loaded.fabric);
    if (options.curves) {
        info["curves"] = inspect(loaded);
    }
    if (options.json) {
        fmt::print("{}\n", info.dump(2));
    } else {
        printText(info);
    }
    return hasErrors(timeline->diagnostics()) ? kProblems : kFine;
}

} // namespace

void addInfo(CLI::App& app, Command& chosen) {
    auto options = std::make_shared<InfoOptions>();
    CLI::App* command =
        app.add_subcommand("info", "Count operations, needles, loops, bonding points and yarn");
    command->add_option("file", options->load.file, "machine file")->required();
    command->add_flag("--json", options->json, "print JSON");
    command->add_flag("--curves", options->curves, "also draw the yarn curves and report how exact they are");
    command->callback([&chosen, options] { chosen = [options] { return runInfo(*options); }; });
}

} // namespace knittsim::cli
