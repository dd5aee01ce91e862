#include "app/cli/commands.h"
#include "core/base/file.h"
#include "core/base/message_table.h"
#include "core/formats/formats.h"
#include "core/pattern/lift.h"
#include "core/pattern/machine_data.h"
#include "core/pattern/project.h"

#include <fmt/core.h>

#include <cstdio>
#include <memory>
#include <string>

namespace knittsim::cli {

namespace {

struct ConvertOptions {
    std::string input;
    std::string output;
};

template<class T> bool printAndTest(const Result<T>& result) {
    for (const Diagnostic& diagnostic : result.diagnostics()) {
        fmt::print(stderr, "{}\n", toLine(diagnostic));
    }
    return result.hasValue();
}

/// The chart of a program; one that is a chart already keeps all that it is.
int convertToChart(const ConvertOptions& options) {
    Result<pattern::Project> project = pattern::readAnyProject(options.input);
    return printAndTest(project) &&
                   printAndTest(writeFileAtomically(options.output, pattern::writeProject(project.value())))
               ? kFine
               : kUnusable;
}

/// A chart is knitted on a machine that takes the format.
Result<machine::Program> programToWrite(const ConvertOptions& options) {
    if (!pattern::isProjectFile(options.input)) {
        return formats::readProgram(options.input);
    }
    const Result<pattern::Project> project = pattern::readProjectFile(options.input);
    if (!project) {
        return Result<machine::Program>::failure(project.diagnostics());
    }
    Diagnostics ignored; // that of `check` tells of bad profiles
    const auto machines = machine::ProfileLibrary::read(machine::profileFolders(), ignored);
    auto data = pattern::machineDataFor(options.output, project.value(), machines);
    return data ? Result<machine::Program>(std::move(data.value().program))
                : Result<machine::Program>::failure(data.diagnostics());
}

int runConvert(const ConvertOptions& options) {
    if (pattern::isProjectFile(options.output)) {
        return convertToChart(options);
    }
    const auto program = programToWrite(options);
    if (!printAndTest(program)) {
        return kUnusable;
    }
    const auto bytes = formats::writeProgram(program.value(), options.output);
    if (!printAndTest(bytes)) {
        return kUnusable;
    }
    return printAndTest(writeFileAtomically(options.output, bytes.value())) ? kFine : kUnusable;
}

} // namespace

void addConvert(CLI::App& app, Command& chosen) {
    auto options = std::make_shared<ConvertOptions>();
    CLI::App* command = app.add_subcommand(
        "convert", "Write a program in another machine format or as a chart, by extension");
    command->add_option("input", options->input, "machine file or chart to read")->required();
    command->add_option("output", options->output, "file to write: .k, .knitout, .dat, .kc or .knitt")
        ->required();
    command->callback([&chosen, options] { chosen = [options] { return runConvert(*options); }; });
}

} // namespace knittsim::cli
