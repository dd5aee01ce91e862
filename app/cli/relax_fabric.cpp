#include "app/cli/relax_fabric.h"

#include "app/cli/commands.h"
#include "app/cli/deadline.h"
#include "app/cli/verdict_text.h"
#include "core/base/file.h"
#include "core/base/message_table.h"
#include "core/simulation/yarn_settling.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <ctime>

namespace knittsim::cli {

namespace {

using simulation::YarnAudit;
using simulation::YarnSettling;

constexpr int kEdge = 6;            ///< a sixth of the fabric
constexpr std::size_t kPlaces = 10; ///< of faults in a report

double ratio(double length, double spacing) {
    return spacing > 0 ? length / spacing : 0;
}

nlohmann::ordered_json loopJson(const Loaded& loaded, machine::LoopIndex loop) {
    if (loop < 0) {
        return nullptr;
    }
    const machine::Loop& made = loaded.fabric->made.loops[static_cast<std::size_t>(loop)];
    return {{"needle", toString(made.needle)},
            {"course", loaded.fabric->loops[static_cast<std::size_t>(loop)].course}};
}

const char* reasonText(physics::StopRule::Verdict verdict) {
    return verdict == physics::StopRule::Verdict::Stagnation ? "energy hardly falls any more"
                                                             : verdictText(verdict);
}

const char* surroundingsId(simulation::Surroundings surroundings) {
    return simulation::surroundingsKinds()[static_cast<std::size_t>(surroundings)].id;
}

/// What the audit found, with places.
void addAudit(nlohmann::ordered_json& r, const Loaded& loaded, const YarnAudit& audit) {
    r["penetrations"] = audit.coreOverlaps;
    r["max_penetration_mm"] = audit.deepestOverlapMm;
    r["nearest_strands"] = {loopJson(loaded, audit.worstLoop), loopJson(loaded, audit.worstOther)};
    r["passed_strands"] = audit.passThroughs();
    nlohmann::ordered_json places = nlohmann::ordered_json::array();
    const auto add = [&](machine::LoopIndex loop, machine::LoopIndex other) {
        if (places.size() < kPlaces) {
            places.push_back({loopJson(loaded, loop), loopJson(loaded, other)});
        }
    };
    for (const geometry::PullThrough& wrong : audit.laidWrong) {
        add(wrong.loop, wrong.parent);
    }
    for (const YarnAudit::Passage& passage : audit.passages) {
        add(passage.loop, passage.other);
    }
    r["passed_places"] = std::move(places);
    r["crossings_expected"] = audit.expectedCrossings;
    r["crossings_laid"] = audit.laidCrossings;
    r["crossings_found"] = audit.foundCrossings;
    r["folded_loops"] = audit.foldedLoops;
}

nlohmann::ordered_json report(const Loaded& loaded, const YarnSettling& settling,
                              const geometry::Measurement& inner, const geometry::Measurement& whole,
                              const YarnSettling::Options& settings) {
    double mass = 0;
    for (const fabric::Yarn& yarn : loaded.fabric->yarns) {
        mass += yarn.lengthMm * loaded.yarns[yarn.carrier].tex * 1e-6;
    }
    const physics::YarnRelaxReport& rest = settling.report();
    const physics::YarnUnits& units = settling.yarns().units;
    return {{"file", loaded.timeline->program().file},
            {"model", "yarn"},
            {"periodic", false},
            {"integrator", settings.integrator},
            {"surroundings", surroundingsId(settings.surroundings)},
            {"converged", isAtRest(rest.verdict)},
            {"reason", reasonText(rest.verdict)},
            {"residual", rest.residual},
            {"steps", rest.steps},
            {"evaluations", rest.evaluations},
            {"removed_loops", loaded.removedLoops},
            {"nodes", settling.yarns().chains.nodeCount()},
            {"width_mm", inner.waleSpacingMm * whole.wales},
            {"height_mm", inner.courseSpacingMm * whole.courses},
            {"wale_spacing_mm", inner.waleSpacingMm},
            {"course_spacing_mm", inner.courseSpacingMm},
            {"wales", whole.wales},
            {"courses", whole.courses},
            {"measured_wales", inner.wales},
            {"measured_courses", inner.courses},
            {"loop_length_mm", inner.loopLengthMm},
            {"kw", ratio(inner.loopLengthMm, inner.waleSpacingMm)},
            {"kc", ratio(inner.loopLengthMm, inner.courseSpacingMm)},
            {"yarn_diameter_mm", units.lengthMm},
            {"mass_g", mass},
            {"energy_uj", rest.energy * units.energyMicroJoule()}};
}

void printText(const nlohmann::ordered_json& r) {
    const auto number = [&](const char* key) { return r[key].get<double>(); };
    fmt::print("{}\n", r["file"].get<std::string>());
    fmt::print("  {} after {} steps of {} on {} nodes: {} (residual {:.2e}, {:.1f} s, CPU {:.1f} s)\n",
               r["converged"].get<bool>() ? "at rest" : "not at rest", r["steps"].get<int>(),
               r["integrator"].get<std::string>(), r["nodes"].get<int>(), r["reason"].get<std::string>(),
               number("residual"), number("wall_seconds"), number("cpu_seconds"));
    fmt::print("  {:.1f} x {:.1f} mm, {} wales x {} courses, mass {:.2f} g\n", number("width_mm"),
               number("height_mm"), r["wales"].get<int>(), r["courses"].get<int>(), number("mass_g"));
    fmt::print(
        "  wale spacing {:.3f} mm, course spacing {:.3f} mm, loop length {:.2f} mm, kw {:.2f}, kc {:.2f}\n",
        number("wale_spacing_mm"), number("course_spacing_mm"), number("loop_length_mm"), number("kw"),
        number("kc"));
    if (r["removed_loops"].get<std::size_t>() > 0) {
        fmt::print("  {} loops have run; their yarn went to the rungs\n",
                   r["removed_loops"].get<std::size_t>());
    }
    fmt::print("  {} core overlaps; {} strands passed through others on the way from {} of {} crossings\n",
               r["penetrations"].get<int>(), r["passed_strands"].get<int>(), r["crossings_laid"].get<int>(),
               r["crossings_expected"].get<int>());
    for (const auto& place : r["passed_places"]) {
        fmt::print("    passed: {} in course {}, {} in course {}\n", place[0]["needle"].get<std::string>(),
                   place[0]["course"].get<int>(), place[1]["needle"].get<std::string>(),
                   place[1]["course"].get<int>());
    }
}

} // namespace

geometry::Region innerRegion(const fabric::Fabric& fabric, std::span<const float> positions) {
    const geometry::Measurement whole = geometry::measure(fabric, positions);
    const int wales = whole.wales / kEdge;
    const int courses = whole.courses / kEdge;
    return {wales, whole.wales - 1 - wales, courses, whole.courses - 1 - courses};
}

void addSurroundings(CLI::App& command, std::string& id) {
    std::vector<std::string> ids;
    for (const simulation::SurroundingsInfo& info : simulation::surroundingsKinds()) {
        ids.emplace_back(info.id);
    }
    command.add_option("--surroundings", id, "what the yarn lies on or hangs from (yarn model); flat")
        ->check(CLI::IsMember(ids));
}

simulation::Surroundings surroundingsOf(const std::string& id) {
    const auto kinds = simulation::surroundingsKinds();
    const auto found = std::ranges::find(kinds, id, &simulation::SurroundingsInfo::id);
    return found == kinds.end() ? simulation::Surroundings::Flat : found->value;
}

bool writeState(const std::string& path, const Loaded& loaded, std::span<const float> positions) {
    const nlohmann::ordered_json state{{"format", "knittsim-state"},
                                       {"version", 1},
                                       {"file", loaded.timeline->program().file},
                                       {"unit", "mm"},
                                       {"table_entries", loaded.fabric->entryCount},
                                       {"positions", positions}};
    const auto written = writeFileAtomically(path, state.dump() + "\n");
    for (const Diagnostic& diagnostic : written.diagnostics()) {
        fmt::print(stderr, "{}\n", toLine(diagnostic));
    }
    return written.hasValue();
}

int relaxFabric(const Loaded& loaded, const FabricYarnOptions& options) {
    const Deadline deadline(options.maxSeconds);
    const std::clock_t cpuStart = std::clock();
    YarnSettling::Options settings;
    settings.residual = options.until;
    settings.surroundings = options.surroundings;
    if (!options.integrator.empty()) {
        settings.integrator = options.integrator.c_str();
    }
    YarnSettling settling(*loaded.fabric, loaded.yarns, settings);
    if (*settling.problem() != '\0') {
        fmt::print(stderr, "--model yarn: {}\n", settling.problem());
        return kUnusable;
    }
    while (settling.step(physics::Interrupt(&deadline.late()))) {
    }
    const std::vector<float> positions =
        simulation::entryPositions(*loaded.fabric, settling.yarns(), settling.shape());
    const geometry::Region region = options.region.value_or(innerRegion(*loaded.fabric, positions));
    nlohmann::ordered_json result =
        report(loaded, settling, geometry::measure(*loaded.fabric, positions, region),
               geometry::measure(*loaded.fabric, positions), settings);
    result["wall_seconds"] = deadline.seconds();
    result["cpu_seconds"] = static_cast<double>(std::clock() - cpuStart) / CLOCKS_PER_SEC;
    const YarnAudit audit = settling.audit();
    addAudit(result, loaded, audit);
    if (options.json) {
        fmt::print("{}\n", result.dump(2));
    } else {
        printText(result);
    }
    if (!options.state.empty() && !writeState(options.state, loaded, positions)) {
        return kUnusable;
    }
    return result["converged"].get<bool>() && audit.holds() ? kFine : kProblems;
}

} // namespace knittsim::cli
