#include "app/cli/load.h"

#include "core/base/message_table.h"
#include "core/base/resources.h"
#include "core/fabric/fabric_builder.h"
#include "core/fabric/reduction.h"
#include "core/formats/formats.h"
#include "core/machine/carrier_yarns.h"
#include "core/machine/profile_library.h"
#include "core/pattern/project.h"
#include "core/yarn/yarn_library.h"

#include <fmt/core.h>

#include <cstdio>

namespace knittsim::cli {

namespace {

void print(const Diagnostics& diagnostics) {
    for (const Diagnostic& diagnostic : diagnostics) {
        fmt::print(stderr, "{}\n", toLine(diagnostic));
    }
}

/// Applies one CARRIER=ID; says what is wrong with it otherwise.
bool assignYarn(const std::string& assignment, const machine::Program& program,
                const yarn::YarnLibrary& library, std::vector<yarn::Yarn>& yarns) {
    const std::size_t equals = assignment.find('=');
    if (equals == std::string::npos) {
        fmt::print(stderr, "--yarn '{}': expected CARRIER=ID, for example 1=merino-2-30\n", assignment);
        return false;
    }
    const std::string name = assignment.substr(0, equals);
    const std::string id = assignment.substr(equals + 1);
    const auto carrier = program.findCarrier(name);
    if (!carrier) {
        fmt::print(stderr, "--yarn '{}': the program has no carrier '{}'\n", assignment, name);
        return false;
    }
    const yarn::Yarn* yarn = library.find(id);
    if (yarn == nullptr) {
        std::string ids;
        for (const yarn::Yarn& known : library.yarns()) {
            ids += (ids.empty() ? "" : ", ") + known.id;
        }
        fmt::print(stderr, "--yarn '{}': no yarn '{}'; there are: {}\n", assignment, id, ids);
        return false;
    }
    yarns[*carrier] = *yarn;
    return true;
}

void reduce(const LoadOptions& options, Loaded& loaded) {
    const fabric::Runs runs = fabric::findRuns(*loaded.fabric, {.stitchHolder = !options.noStitchHolder});
    loaded.removedLoops = runs.loopCount();
    auto reduced = std::make_shared<fabric::Fabric>(fabric::removeRuns(*loaded.fabric, runs).fabric);
    if (reduced->points.empty() && !loaded.fabric->points.empty()) {
        fmt::print(stderr, "--reduce: nothing holds this fabric; all of it has run\n");
    }
    loaded.fabric = std::move(reduced);
}

} // namespace

void addReduction(CLI::App& command, LoadOptions& options) {
    CLI::Option* reduce =
        command.add_flag("--reduce", options.reduce, "first take out the loops that nothing holds (ladders)");
    command
        .add_flag("--no-stitch-holder", options.noStitchHolder,
                  "with --reduce: loops left on needles run as well")
        ->needs(reduce);
}

void addFabric(CLI::App& command, LoadOptions& options) {
    command.add_option("--step", options.step, "the fabric after N operations")
        ->check(CLI::NonNegativeNumber);
    command.add_option("--yarn", options.yarns, "CARRIER=ID: yarn of a carrier, from the library");
    command.add_option("--loop-length", options.loopLengthMm, "MM of yarn in every loop")
        ->check(CLI::Range(0.1, 200.0));
    addReduction(command, options);
}

std::shared_ptr<const machine::Timeline> loadTimeline(const LoadOptions& options) {
    auto program = pattern::readAnyProgram(options.file);
    print(program.diagnostics());
    if (!program) {
        return nullptr;
    }
    Diagnostics problems;
    const auto library = machine::ProfileLibrary::read(machine::profileFolders(), problems);
    print(problems);
    auto profile = machine::chooseProfile(program.value(), library);
    print(profile.diagnostics());
    if (!profile) {
        return nullptr;
    }
    if (options.loopLengthMm > 0) {
        profile->defaultLoopLengthMm = options.loopLengthMm;
        profile->stitchTable.clear();
    }
    auto timeline =
        std::make_shared<machine::Timeline>(std::move(program).value(), std::move(profile).value());
    print(timeline->diagnostics());
    return timeline;
}

std::optional<Loaded> load(const LoadOptions& options) {
    Loaded loaded;
    loaded.timeline = loadTimeline(options);
    if (!loaded.timeline) {
        return std::nullopt;
    }
    auto library = yarn::YarnLibrary::read(resourceFolder() / "yarns");
    print(library.diagnostics());
    if (!library) {
        return std::nullopt;
    }
    const machine::Program& program = loaded.timeline->program();
    loaded.yarns = machine::yarnsOf(machine::carrierYarns(program, library.value(), yarn::defaultYarn()));
    for (const std::string& assignment : options.yarns) {
        if (!assignYarn(assignment, program, library.value(), loaded.yarns)) {
            return std::nullopt;
        }
    }
    loaded.fabric = std::make_shared<fabric::Fabric>(fabric::buildFabric(*loaded.timeline, options.step));
    if (options.reduce) {
        reduce(options, loaded);
    }
    return loaded;
}

} // namespace knittsim::cli
