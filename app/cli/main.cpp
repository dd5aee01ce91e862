#include "app/cli/commands.h"

#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <fmt/core.h>

#include <cstdio>
#include <exception>

int main(int argc, char** argv) {
    using namespace knittsim::cli;
    CLI::App app("Reads knitting-machine data, emulates the machine and settles the fabric.", "knittsim-cli");
    app.set_version_flag("--version", "knittsim-cli " KNITTSIM_VERSION);
    app.require_subcommand(1);
    app.footer("Exit code: 0 fine, 1 problems found, 2 cannot read or bad usage.");
    Command chosen;
    addInfo(app, chosen);
    addCheck(app, chosen);
    addRelax(app, chosen);
    addPull(app, chosen);
    addRender(app, chosen);
    addExport(app, chosen);
    addConvert(app, chosen);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? kFine : kUnusable;
    }
    try {
        return chosen();
    } catch (const std::exception& error) {
        fmt::print(stderr, "knittsim-cli: {}\n", error.what());
        return kUnusable;
    }
}
