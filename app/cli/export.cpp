#include "app/cli/commands.h"
#include "app/cli/load.h"
#include "app/cli/settle.h"
#include "core/base/message_table.h"
#include "core/export/write_shape.h"

#include <fmt/core.h>

#include <csignal>
#include <cstdio>
#include <memory>
#include <string>

namespace knittsim::cli {

namespace {

struct ExportOptions {
    LoadOptions load;
    SettleOptions settle;
    std::string file;
    std::string side = "front";
    int sides = exports::WriteOptions().sides;
};

volatile std::sig_atomic_t interrupted = 0;

/// While it lives, Ctrl+C ends the work instead of the program, so that no half-written file stays.
class CatchInterrupt {
public:
    CatchInterrupt() : m_before(std::signal(SIGINT, [](int) { interrupted = 1; })) {}
    ~CatchInterrupt() { std::signal(SIGINT, m_before); }
    CatchInterrupt(const CatchInterrupt&) = delete;
    CatchInterrupt& operator=(const CatchInterrupt&) = delete;

private:
    void (*m_before)(int);
};

void print(const Diagnostics& diagnostics) {
    for (const Diagnostic& diagnostic : diagnostics) {
        fmt::print(stderr, "{}\n", toLine(diagnostic));
    }
}

int write(const ExportOptions& options, const Loaded& loaded, Settled settled) {
    const CatchInterrupt guard;
    const Progress progress = [](double) { return interrupted == 0; };
    std::optional<exports::Shape> shape;
    if (settled.curves) {
        shape = exports::shapeOf(loaded.fabric, loaded.yarns, std::move(*settled.curves),
                                 std::move(settled.places));
    } else {
        shape = exports::shapeAt(loaded.fabric, loaded.yarns, std::move(settled.places), progress);
    }
    if (!shape) {
        return kUnusable;
    }
    const auto written = exports::writeShape(
        options.file, *shape, {.sides = options.sides, .back = options.side == "back"}, progress);
    print(written.diagnostics());
    if (!written) {
        return kUnusable;
    }
    return hasErrors(loaded.timeline->diagnostics()) ? kProblems : kFine;
}

int runExport(const ExportOptions& options) {
    if (!exports::formatOf(options.file)) { // before the work
        print(exports::writeShape(options.file, {}).diagnostics());
        return kUnusable;
    }
    const auto loaded = load(options.load);
    if (!loaded) {
        return kUnusable;
    }
    auto settled = settle(*loaded, options.settle);
    if (!settled) {
        return kUnusable;
    }
    return write(options, *loaded, std::move(*settled));
}

} // namespace

void addExport(CLI::App& app, Command& chosen) {
    auto options = std::make_shared<ExportOptions>();
    CLI::App* command = app.add_subcommand(
        "export", "Write the fabric as geometry (OBJ, glTF, BCC), drawing (SVG) or table (CSV)");
    command->add_option("file", options->load.file, "machine file")->required();
    command->add_option("-o", options->file, "file to write: .obj, .gltf, .glb, .bcc, .svg or .csv")
        ->required();
    addSettling(*command, options->settle);
    command->add_option("--side", options->side, "side that the drawing shows")
        ->check(CLI::IsMember({"front", "back"}))
        ->capture_default_str();
    command->add_option("--tube-sides", options->sides, "sides of a yarn's tube")
        ->check(CLI::Range(3, 64))
        ->capture_default_str();
    addFabric(*command, options->load);
    command->callback([&chosen, options] { chosen = [options] { return runExport(*options); }; });
}

} // namespace knittsim::cli
