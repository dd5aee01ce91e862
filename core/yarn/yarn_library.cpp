#include "core/yarn/yarn_library.h"

#include "core/base/file.h"
#include "core/base/json_places.h"
#include "core/base/json_reader.h"
#include "core/base/units.h"
#include "core/yarn/colour_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <system_error>

namespace knittsim::yarn {

namespace {

/// Largest yarn file that is read; the library's own files have about 2 kB.
constexpr std::size_t kMaxYarnBytes = std::size_t{1} << 20;
/// Of a library in one file.
constexpr std::size_t kMaxLibraryBytes = std::size_t{16} << 20;
constexpr std::size_t kMostYarns = 10'000;
constexpr const char* kYarnsKey = "yarns";
/// Nm and Ne must agree with tex to this part; hand-made files round them.
constexpr double kCountTolerance = 0.01;

const std::vector<std::string> kSurfaceKinds{"smooth",   "hairy",   "bulky",  "matte", "glossy",
                                             "lustrous", "crimped", "slubby", "halo",  "soft"};

bool agrees(double value, double expected) {
    return std::abs(value - expected) <= kCountTolerance * expected;
}

void readCount(JsonReader reader, Yarn& yarn) {
    const std::size_t before = reader.problemCount();
    yarn.count = reader.text("as_written");
    yarn.tex = reader.number("tex", 0.1, 20'000);
    const double nm = reader.number("nm", 0.01, 20'000);
    const double ne = reader.number("ne", 0.01, 20'000);
    const bool comparable = reader.has("tex") && reader.problemCount() == before;
    if (comparable && !agrees(nm, yarn.nm())) {
        reader.report("nm", fmt::format("{}", nm),
                      fmt::format("about {:.4g}, that is 1000 / tex", yarn.nm()));
    }
    if (comparable && !agrees(ne, yarn.ne())) {
        reader.report("ne", fmt::format("{}", ne),
                      fmt::format("about {:.4g}, that is 590.54 / tex", yarn.ne()));
    }
    reader.rejectUnknownKeys();
}

void readDiameters(JsonReader& reader, Yarn& yarn) {
    const std::size_t before = reader.problemCount();
    yarn.outerDiameterMm = reader.number("outer_diameter_mm", 0.01, 50);
    yarn.coreDiameterMm = reader.number("core_diameter_mm", 0.005, 50);
    if (reader.problemCount() == before && yarn.coreDiameterMm > yarn.outerDiameterMm) {
        reader.report("core_diameter_mm", fmt::format("{}", yarn.coreDiameterMm),
                      fmt::format("at most outer_diameter_mm, {}", yarn.outerDiameterMm));
    }
}

Surface readSurface(JsonReader reader) {
    Surface surface;
    surface.kind = reader.choice("kind", kSurfaceKinds);
    surface.hairiness = reader.number("hairiness", 0, 1);
    surface.plies = reader.integer("plies", 1, 100);
    surface.twistPerMetre = reader.number("twist_per_metre", -5000, 5000);
    surface.melange = reader.number("melange", 0, 1);
    reader.rejectUnknownKeys();
    return surface;
}

std::map<std::string, std::string> readSources(JsonReader reader) {
    std::map<std::string, std::string> sources;
    for (const char* key : {"count", "outer_diameter_mm", "core_diameter_mm", "axial_stiffness_n",
                            "bending_stiffness_n_m2", "friction", "colour", "surface"}) {
        if (const std::string text = reader.optionalText(key); !text.empty()) {
            sources.emplace(key, text);
        }
    }
    reader.rejectUnknownKeys();
    return sources;
}

Yarn yarnOf(JsonReader& reader) {
    Yarn yarn;
    yarn.id = reader.text("id");
    yarn.name = reader.text("name");
    yarn.fibre = reader.text("fibre");
    readCount(reader.object("count"), yarn);
    readDiameters(reader, yarn);
    const double axial = reader.number("axial_stiffness_n", 1e-3, 1e6);
    const double bending = reader.number("bending_stiffness_n_m2", 1e-13, 1e-3);
    yarn.axialStiffnessMilliNewton = roundDecimal(units::fromNewton(axial));
    yarn.bendingStiffness = roundDecimal(units::fromNewtonSquareMetre(bending));
    yarn.friction = reader.number("friction", 0, 2);
    yarn.colour = readColour(reader);
    yarn.surface = readSurface(reader.object("surface"));
    yarn.sources = readSources(reader.object("sources"));
    yarn.note = reader.optionalText("note");
    reader.rejectUnknownKeys();
    return yarn;
}

/// Four significant digits: enough for a count.
double roundCount(double value) {
    const double scale = std::pow(10.0, 3 - std::floor(std::log10(value)));
    return roundDecimal(std::round(value * scale) / scale);
}

Diagnostics asWarnings(Diagnostics diagnostics) {
    for (Diagnostic& diagnostic : diagnostics) {
        diagnostic.severity = Severity::Warning;
    }
    return diagnostics;
}

} // namespace

Result<Yarn> parseYarn(std::string_view json, const std::string& file) {
    const Result<nlohmann::json> document = parseJson(json, file);
    if (!document) {
        return Result<Yarn>::failure(document.diagnostics());
    }
    Diagnostics diagnostics;
    JsonReader reader(document.value(), file, diagnostics);
    Yarn yarn = yarnOf(reader);
    if (hasErrors(diagnostics)) {
        tellLines(json, diagnostics);
        return Result<Yarn>::failure(std::move(diagnostics));
    }
    return yarn;
}

Result<Yarn> readYarn(const std::filesystem::path& path) {
    const Result<std::string> bytes = readFile(path, kMaxYarnBytes);
    return bytes ? parseYarn(bytes.value(), path.string()) : Result<Yarn>::failure(bytes.diagnostics());
}

Result<std::vector<Yarn>> parseYarns(std::string_view json, const std::string& file) {
    const Result<nlohmann::json> document = parseJson(json, file);
    if (!document) {
        return Result<std::vector<Yarn>>::failure(document.diagnostics());
    }
    Diagnostics diagnostics;
    std::vector<Yarn> yarns;
    JsonReader reader(document.value(), file, diagnostics);
    if (reader.has(kYarnsKey)) {
        const std::vector<nlohmann::json> all = reader.array(kYarnsKey, 1, kMostYarns);
        for (std::size_t i = 0; i < all.size(); ++i) {
            JsonReader one(all[i], file, diagnostics, fmt::format("{}[{}]", kYarnsKey, i));
            yarns.push_back(yarnOf(one));
        }
        reader.rejectUnknownKeys();
    } else {
        yarns.push_back(yarnOf(reader));
    }
    if (hasErrors(diagnostics)) {
        return Result<std::vector<Yarn>>::failure(std::move(diagnostics));
    }
    return yarns;
}

Result<std::vector<Yarn>> readYarns(const std::filesystem::path& path) {
    const Result<std::string> bytes = readFile(path, kMaxLibraryBytes);
    return bytes ? parseYarns(bytes.value(), path.string())
                 : Result<std::vector<Yarn>>::failure(bytes.diagnostics());
}

namespace {

nlohmann::ordered_json jsonOf(const Yarn& yarn) {
    nlohmann::ordered_json json;
    json["id"] = yarn.id;
    json["name"] = yarn.name;
    json["fibre"] = yarn.fibre;
    json["count"] = {{"as_written", yarn.count},
                     {"tex", yarn.tex},
                     {"nm", roundCount(yarn.nm())},
                     {"ne", roundCount(yarn.ne())}};
    json["outer_diameter_mm"] = yarn.outerDiameterMm;
    json["core_diameter_mm"] = yarn.coreDiameterMm;
    json["axial_stiffness_n"] = roundDecimal(yarn.axialStiffnessMilliNewton / units::fromNewton(1));
    json["bending_stiffness_n_m2"] = roundDecimal(yarn.bendingStiffness / units::fromNewtonSquareMetre(1));
    json["friction"] = yarn.friction;
    json["colour"] = colourText(yarn.colour);
    json["surface"] = {{"kind", yarn.surface.kind},
                       {"hairiness", yarn.surface.hairiness},
                       {"plies", yarn.surface.plies},
                       {"twist_per_metre", yarn.surface.twistPerMetre},
                       {"melange", yarn.surface.melange}};
    json["sources"] = nlohmann::ordered_json::object();
    for (const auto& [key, text] : yarn.sources) {
        json["sources"][key] = text;
    }
    if (!yarn.note.empty()) {
        json["note"] = yarn.note;
    }
    return json;
}

std::string textOf(const nlohmann::ordered_json& json) {
    using ErrorHandler = nlohmann::ordered_json::error_handler_t;
    return json.dump(2, ' ', false, ErrorHandler::replace) + '\n';
}

} // namespace

std::string toJson(const Yarn& yarn) {
    return textOf(jsonOf(yarn));
}

std::string toJson(std::vector<Yarn> yarns) {
    std::ranges::stable_sort(yarns, {}, &Yarn::id);
    nlohmann::ordered_json all = nlohmann::ordered_json::array();
    for (const Yarn& yarn : yarns) {
        all.push_back(jsonOf(yarn));
    }
    return textOf({{kYarnsKey, all}});
}

YarnLibrary::YarnLibrary(std::vector<Yarn> yarns) : m_yarns(std::move(yarns)) {
    std::ranges::stable_sort(m_yarns, {}, &Yarn::id);
}

const Yarn* YarnLibrary::find(std::string_view id) const {
    const auto found =
        std::ranges::lower_bound(m_yarns, id, {}, [](const Yarn& y) { return std::string_view(y.id); });
    return found != m_yarns.end() && found->id == id ? &*found : nullptr;
}

Result<YarnLibrary> YarnLibrary::read(const std::filesystem::path& folder) {
    std::vector<Yarn> yarns;
    Diagnostics warnings;
    const auto warn = [&](const Diagnostics& diagnostics) {
        const Diagnostics softened = asWarnings(diagnostics);
        warnings.insert(warnings.end(), softened.begin(), softened.end());
    };
    for (const std::filesystem::path& path : jsonFiles(folder)) {
        const Result<Yarn> yarn = readYarn(path);
        warn(yarn.diagnostics());
        if (!yarn) {
            continue;
        }
        if (std::ranges::count(yarns, yarn.value().id, &Yarn::id) > 0) {
            warn({{"KS0004",
                   Severity::Warning,
                   Place{.file = path.string()},
                   {"id", '"' + yarn.value().id + '"', "an id that no other file has"}}});
            continue;
        }
        yarns.push_back(yarn.value());
    }
    if (yarns.empty()) {
        warnings.push_back(
            {"KS0001", Severity::Error, Place{.file = folder.string()}, {"it holds no yarn (*.json)"}});
        return Result<YarnLibrary>::failure(std::move(warnings));
    }
    return {YarnLibrary(std::move(yarns)), std::move(warnings)};
}

Yarn defaultYarn() {
    Yarn yarn;
    yarn.id = "merino-2-30";
    yarn.name = "Merino 2/30";
    yarn.fibre = "wool, merino 19.5 um";
    yarn.count = "Nm 2/30";
    yarn.tex = 66.6667;
    yarn.colour = {0xe9, 0xdf, 0xc8};
    return yarn;
}

} // namespace knittsim::yarn
