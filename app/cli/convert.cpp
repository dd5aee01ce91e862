#include "app/cli/commands.h"
#include "core/base/file.h"
#include "core/base/message_table.h"
#include "core/formats/formats.h"
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

int runConvert(const ConvertOptions& options) {
    const auto program = pattern::readAnyProgram(options.input);
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
    CLI::App* command =
        app.add_subcommand("convert", "Write a program in another machine format, by extension");
    command->add_option("input", options->input, "machine file to read")->required();
    command->add_option("output", options->output, "file to write: .k, .knitout, .dat or .kc")->required();
    command->callback([&chosen, options] { chosen = [options] { return runConvert(*options); }; });
}

} // namespace knittsim::cli
