#include "app/cli/commands.h"
#include "app/cli/load.h"
#include "app/cli/relax_fabric.h"
#include "app/cli/settle.h"
#include "core/base/message_table.h"
#include "core/simulation/settling_record.h"
#include "ui/render/colour_scale.h"
#include "ui/render/offscreen.h"
#include "ui/render/picture_sequence.h"

#include <fmt/core.h>

#include <cstdio>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <unistd.h>

namespace knittsim::cli {

namespace {

using render::ColourBy;

constexpr int kMaxPixels = 8192;

struct RenderOptions {
    LoadOptions load;
    SettleOptions settle;
    std::string picture;
    render::DrawStyle style = render::DrawStyle::Yarn;
    render::ViewSide side = render::ViewSide::Front;
    std::string size = "1280x800";
    bool dark = false;
    bool transparent = false;
    ColourBy colour = ColourBy::Yarn;
    bool noFuzz = false;
    std::string detail = "auto";
    std::string frames; ///< folder; none when empty
};

bool parseSize(const std::string& text, int& width, int& height) {
    int used = 0;
    return std::sscanf(text.c_str(), "%dx%d%n", &width, &height, &used) == 2 &&
           static_cast<std::size_t>(used) == text.size() && width > 0 && height > 0 && width <= kMaxPixels &&
           height <= kMaxPixels;
}

/// What the colours of the picture mean.
void printScale(ColourBy colour, std::span<const float> values) {
    const render::ValueRange range = render::rangeOf(values);
    const bool tension = colour == ColourBy::Tension;
    fmt::print("{} from {:g} {} (dark violet) to {:g} (yellow)\n", tension ? "yarn tension" : "contact force",
               range.low, tension ? "mN" : "mN/mm", range.high);
}

/// Nothing for "auto".
std::optional<render::DetailLevel> levelOf(const std::string& name) {
    using render::DetailLevel;
    return name == "yarn"      ? std::optional(DetailLevel::Yarn)
           : name == "tubes"   ? std::optional(DetailLevel::Tubes)
           : name == "strokes" ? std::optional(DetailLevel::Strokes)
                               : std::nullopt;
}

void print(const Diagnostics& diagnostics) {
    for (const Diagnostic& diagnostic : diagnostics) {
        fmt::print(stderr, "{}\n", toLine(diagnostic));
    }
}

/// The way of the fabric from the machine to rest, as numbered pictures.
int drawFrames(const Loaded& loaded, const RenderOptions& options, const render::RenderRequest& look) {
    const simulation::RecordOptions record{.yarn = options.settle.relax == "yarn",
                                           .surroundings = surroundingsOf(options.settle.surroundings),
                                           .maxSeconds = options.settle.maxSeconds};
    const auto shapes = simulation::recordSettling(loaded.fabric, loaded.yarns, record);
    print(shapes.diagnostics());
    if (!shapes) {
        return kUnusable;
    }
    const bool told = isatty(STDERR_FILENO) != 0;
    const auto written = render::writeSequence(options.frames, look, shapes.value(), [told](double share) {
        if (told) {
            fmt::print(stderr, "\rdrawing {:3.0f} %", 100 * share);
        }
        return true;
    });
    if (told) {
        fmt::print(stderr, "\r             \r");
    }
    print(written.diagnostics());
    if (!written) {
        return kUnusable;
    }
    fmt::print("{} pictures in {}\n", shapes->size(), options.frames);
    return hasErrors(loaded.timeline->diagnostics()) ? kProblems : kFine;
}

int runRender(const RenderOptions& options) {
    render::RenderRequest request;
    if (!parseSize(options.size, request.width, request.height)) {
        fmt::print(stderr, "--size '{}': expected WxH, each from 1 to {}\n", options.size, kMaxPixels);
        return kUnusable;
    }
    if (options.settle.relax == "yarn" && options.style == render::DrawStyle::Mesh) {
        fmt::print(stderr, "--style mesh shows bonding points; --relax yarn settles yarn curves\n");
        return kUnusable;
    }
    const bool known = options.settle.relax == "yarn" || options.colour == ColourBy::Yarn ||
                       (options.settle.relax == "bonding-points" && options.colour == ColourBy::Tension);
    if (!known) {
        fmt::print(stderr, "--colour tension needs a relaxed fabric, --colour contact --relax yarn\n");
        return kUnusable;
    }
    if (options.picture.empty() && options.frames.empty()) {
        fmt::print(stderr, "-o OUT.png or --frames FOLDER is needed\n");
        return kUnusable;
    }
    if (!options.frames.empty() && (options.settle.relax == "none" || options.colour != ColourBy::Yarn)) {
        fmt::print(stderr, "--frames needs --relax bonding-points or yarn, and no --colour\n");
        return kUnusable;
    }
    const auto loaded = load(options.load);
    if (!loaded) {
        return kUnusable;
    }
    for (const yarn::Yarn& yarn : loaded->yarns) {
        request.looks.push_back(render::lookOf(yarn));
    }
    request.fabric = loaded->fabric.get();
    request.style = options.style;
    request.side = options.side;
    request.hair = !options.noFuzz;
    request.level = levelOf(options.detail);
    request.dark = options.dark;
    request.transparent = options.transparent;
    if (!options.frames.empty()) {
        return drawFrames(*loaded, options, request);
    }
    const auto settled = settle(*loaded, options.settle);
    if (!settled) {
        return kUnusable;
    }
    if (options.colour != ColourBy::Yarn) {
        request.values = options.colour == ColourBy::Tension ? settled->tension : settled->contact;
        printScale(options.colour, request.values);
    }
    request.curves = settled->curves ? &*settled->curves : nullptr;
    request.positions = settled->places;
    const auto image = render::renderFabric(request);
    print(image.diagnostics());
    if (!image) {
        return kUnusable;
    }
    const auto written = render::writePng(options.picture, image.value());
    print(written.diagnostics());
    if (!written) {
        return kUnusable;
    }
    return hasErrors(loaded->timeline->diagnostics()) ? kProblems : kFine;
}

} // namespace

void addRender(CLI::App& app, Command& chosen) {
    using render::DrawStyle;
    using render::ViewSide;
    static const std::map<std::string, DrawStyle> kStyles{
        {"strokes", DrawStyle::Strokes}, {"yarn", DrawStyle::Yarn}, {"mesh", DrawStyle::Mesh}};
    static const std::map<std::string, ViewSide> kSides{{"front", ViewSide::Front}, {"back", ViewSide::Back}};
    static const std::map<std::string, ColourBy> kColours{
        {"yarn", ColourBy::Yarn}, {"tension", ColourBy::Tension}, {"contact", ColourBy::Contact}};
    auto options = std::make_shared<RenderOptions>();
    CLI::App* command = app.add_subcommand("render", "Draw the fabric into a PNG file; needs no display");
    command->add_option("file", options->load.file, "machine file")->required();
    auto* picture = command->add_option("-o", options->picture, "PNG file to write");
    auto* frames =
        command->add_option("--frames", options->frames,
                            "folder to make: the settling as numbered PNG pictures (--relax says which)");
    frames->excludes(picture);
    command->add_option("--style", options->style, "strokes, yarn or mesh")
        ->transform(CLI::CheckedTransformer(kStyles));
    command
        ->add_option("--colour", options->colour,
                     "what colours tell: yarn, tension (mN) or contact (mN/mm of yarn; --relax yarn)")
        ->transform(CLI::CheckedTransformer(kColours));
    command->add_option("--side", options->side, "front or back")->transform(CLI::CheckedTransformer(kSides));
    command->add_option("--size", options->size, "WxH in pixels")->capture_default_str();
    addSettling(*command, options->settle);
    addFabric(*command, options->load);
    command
        ->add_option(
            "--detail", options->detail,
            "how finely yarns are drawn: auto (as their width asks), yarn (with plies), tubes or strokes")
        ->check(CLI::IsMember({"auto", "yarn", "tubes", "strokes"}))
        ->capture_default_str();
    command->add_flag("--no-fuzz", options->noFuzz, "no loose fibres around hairy yarn");
    command->add_flag("--dark", options->dark, "dark background");
    command->add_flag("--transparent", options->transparent, "no background");
    command->callback([&chosen, options] { chosen = [options] { return runRender(*options); }; });
}

} // namespace knittsim::cli
