#include "core/pattern/project.h"

#include "core/base/file.h"
#include "core/base/json_places.h"
#include "core/base/json_reader.h"
#include "core/formats/formats.h"
#include "core/machine/emulator.h"
#include "core/pattern/cell_letters.h"
#include "core/pattern/chart_edit.h"
#include "core/pattern/program_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <span>

namespace knittsim::pattern {

namespace {

using nlohmann::json;

constexpr std::size_t kMaxProjectBytes = std::size_t{256} << 20;
constexpr std::string_view kThumbnailKey = "thumbnail";
constexpr std::string_view kViewKey = "view";
constexpr std::size_t kMaxShape = 60'000'000;
constexpr double kMicrometres = 1000;            ///< in a millimetre
constexpr double kFarthest = 1e9;                ///< micrometres
constexpr std::size_t kMaxThumbnail = 96 * 1024; ///< it stands at the start of the file

const std::vector<std::string> kMethods{"float", "intarsia", "birdseye", "ladder"}; ///< by ColourMethod

/// One course, on one line.
std::string courseText(const Chart& chart, int c) {
    const Course& course = chart.course(c);
    const std::span<const Cell> cells(chart.cells.data() + std::ptrdiff_t{c} * chart.width,
                                      static_cast<std::size_t>(chart.width));
    std::string text =
        fmt::format(R"({{"stitches": "{}", "yarns": "{}")", stitchLetters(cells), yarnDigits(cells));
    if (!course.moves.empty()) {
        text += ", \"moves\": " + movesText(course.moves);
    }
    if (course.colours != ColourMethod::Float) {
        text += fmt::format(R"(, "colours": "{}")", kMethods[static_cast<std::size_t>(course.colours)]);
    }
    if (course.rack != 0) {
        text += fmt::format(", \"rack\": {}", course.rack);
    }
    if (course.stitchNumber) {
        text += fmt::format(", \"stitch\": {}", *course.stitchNumber);
    }
    if (course.program) {
        text += ", \"program\": " + programText(*course.program);
    }
    return text + '}';
}

class Reader {
public:
    Reader(const json& file, std::string name, std::vector<float>* shape)
        : m_name(std::move(name)), m_reader(file, m_name, m_problems), m_shape(shape) {}

    Result<Project> read() {
        const int version = m_reader.integer("knitt", 1, 1'000'000);
        if (m_problems.empty() && version > kProjectVersion) {
            return Diagnostic{"KS0509",
                              Severity::Error,
                              Place{.file = m_name},
                              {std::to_string(version), std::to_string(kProjectVersion)}};
        }
        m_project.machine = m_reader.optionalText("machine");
        m_project.castOn = m_reader.choice("cast_on", {"open", "alternating"}) == "open"
                               ? CastOn::Open
                               : CastOn::Alternating;
        m_project.ending =
            m_reader.choice("ending", {"held", "dropped"}) == "dropped" ? Ending::Dropped : Ending::Held;
        const bool both = m_reader.choice("beds", {"single", "double"}) == "double";
        const int wales = m_reader.integer("wales", 1, kMaxWales);
        if (m_reader.has("first_needle")) {
            m_project.firstNeedle =
                m_reader.integer("first_needle", -machine::kMaxNeedleIndex, machine::kMaxNeedleIndex);
        }
        readYarns();
        m_project.colourways = readColourways(m_reader, m_name, m_problems);
        m_reader.optionalText("thumbnail"); // for readLook()
        m_reader.optionalText("view");
        const std::vector<json> courses = m_reader.array("courses", 1, kMaxCourses);
        if (!m_problems.empty()) {
            return Result<Project>::failure(std::move(m_problems));
        }
        m_project.chart.width = wales;
        m_project.chart.beds = both ? BedUse::Double : BedUse::Single;
        m_project.chart.courses.resize(courses.size());
        m_project.chart.cells.resize(courses.size() * static_cast<std::size_t>(wales));
        for (std::size_t c = 0; c < courses.size() && m_problems.empty(); ++c) {
            readCourse(courses[c], static_cast<int>(c));
        }
        readShape();
        m_reader.rejectUnknownKeys();
        if (version < 3 && both) {
            nameRearBeds(m_project.chart);
        }
        if (m_problems.empty()) {
            takeStructure();
        }
        if (!m_problems.empty()) {
            return Result<Project>::failure(std::move(m_problems));
        }
        return std::move(m_project);
    }

private:
    /// What is no chart at all is refused; what only cannot be knitted can be opened and mended.
    void takeStructure() {
        m_problems = check(m_project.chart);
        std::erase_if(m_problems, [](const Diagnostic& problem) {
            return problem.id != "KS0501" && problem.id != "KS0503";
        });
    }

    void readShape() {
        if (!m_reader.has("shape")) {
            return;
        }
        const std::vector<json> places = m_reader.array("shape", 3, kMaxShape);
        const auto isPlace = [](const json& place) {
            return place.is_number() && std::abs(place.get<double>()) <= kFarthest;
        };
        const auto bad = std::ranges::find_if_not(places, isPlace);
        if (bad != places.end()) {
            m_reader.report("shape", bad->dump(), "a place in micrometres");
        } else if (m_shape != nullptr) {
            m_shape->clear();
            m_shape->reserve(places.size());
            for (const json& place : places) {
                m_shape->push_back(static_cast<float>(place.get<double>() / kMicrometres));
            }
        }
    }

    void readYarns() {
        const std::vector<json> yarns = m_reader.array("yarns", 1, kMaxChartYarns);
        for (std::size_t i = 0; i < yarns.size(); ++i) {
            JsonReader reader(yarns[i], m_name, m_problems, fmt::format("yarns[{}]", i));
            m_project.chart.yarns.push_back(readChartYarn(reader));
        }
    }

    void readCourse(const json& value, int c) {
        Chart& chart = m_project.chart;
        JsonReader reader(value, m_name, m_problems, fmt::format("courses[{}]", c));
        const std::span<Cell> cells(chart.cells.data() + std::ptrdiff_t{c} * chart.width,
                                    static_cast<std::size_t>(chart.width));
        if (!readCells(reader, cells)) {
            return;
        }
        readSettings(reader, c);
        reader.rejectUnknownKeys();
    }

    void readSettings(JsonReader& reader, int c) {
        Course& course = m_project.chart.course(c);
        course.moves = readMoves(reader);
        if (reader.has("colours")) {
            const std::string method = reader.choice("colours", kMethods);
            const auto found = std::ranges::find(kMethods, method);
            course.colours = static_cast<ColourMethod>((found - kMethods.begin()) % kColourMethods);
        }
        if (reader.has("rack")) {
            course.rack = reader.integer("rack", -1000, 1000);
        }
        if (reader.has("stitch")) {
            course.stitchNumber = reader.number("stitch", 0, 1e6);
        }
        if (reader.has("program")) {
            JsonReader program = reader.object("program");
            course.program = readProgramCourse(program, m_project.chart);
        }
    }

    std::string m_name;
    Diagnostics m_problems;
    JsonReader m_reader;
    std::vector<float>* m_shape;
    Project m_project;
};

} // namespace

std::string writeProject(const Project& project, const ProjectLook& look) {
    const Chart& chart = project.chart;
    std::string text = fmt::format("{{\n\"knitt\": {},\n", kProjectVersion);
    for (const auto& [key, value] : {std::pair{kThumbnailKey, &look.thumbnail}, {kViewKey, &look.view}}) {
        if (!value->empty()) {
            text += fmt::format("\"{}\": \"{}\",\n", key, *value);
        }
    }
    if (!project.machine.empty()) {
        text += fmt::format("\"machine\": {},\n", json(project.machine).dump());
    }
    text += fmt::format("\"cast_on\": \"{}\",\n\"ending\": \"{}\",\n\"beds\": \"{}\",\n\"wales\": {},\n",
                        project.castOn == CastOn::Open ? "open" : "alternating",
                        project.ending == Ending::Dropped ? "dropped" : "held",
                        chart.beds == BedUse::Double ? "double" : "single", chart.width);
    if (project.firstNeedle != kFirstNeedle) {
        text += fmt::format("\"first_needle\": {},\n", project.firstNeedle);
    }
    text += "\"yarns\": [";
    for (std::size_t i = 0; i < chart.yarns.size(); ++i) {
        text += fmt::format("{}\n{}", i > 0 ? "," : "", yarnText(chart.yarns[i]));
    }
    text += "\n],\n" + colourwaysText(project.colourways, chart) + "\"courses\": [";
    for (int c = 0; c < chart.height(); ++c) {
        text += (c > 0 ? ",\n" : "\n") + courseText(chart, c);
    }
    text += "\n]";
    if (!look.shape.empty()) {
        text += ",\n\"shape\": [";
        for (std::size_t i = 0; i < look.shape.size(); ++i) {
            fmt::format_to(std::back_inserter(text), "{}{}",
                           i == 0       ? ""
                           : i % 3 == 0 ? ",\n"
                                        : ",",
                           std::lround(static_cast<double>(look.shape[i]) * kMicrometres));
        }
        text += ']';
    }
    return text + "\n}\n";
}

Result<Project> readProject(std::string_view text, const std::string& file, std::vector<float>* shape) {
    Result<json> parsed = parseJson(text, file);
    if (!parsed) {
        return Result<Project>::failure(parsed.diagnostics());
    }
    Result<Project> project = Reader(parsed.value(), file, shape).read();
    if (project) {
        return project;
    }
    Diagnostics problems = project.diagnostics();
    tellLines(text, problems);
    return Result<Project>::failure(std::move(problems));
}

ProjectLook readLook(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::string start(kMaxThumbnail, '\0');
    file.read(start.data(), static_cast<std::streamsize>(start.size()));
    start.resize(static_cast<std::size_t>(file.gcount()));
    const auto valueOf = [&](std::string_view name) {
        const std::string key = fmt::format("\"{}\": \"", name);
        const std::size_t at = start.find(key);
        const std::size_t first = at + key.size();
        const std::size_t end = at == std::string::npos ? at : start.find('"', first);
        return end == std::string::npos ? std::string() : start.substr(first, end - first);
    };
    return {valueOf(kThumbnailKey), valueOf(kViewKey)};
}

Result<Project> readProjectFile(const std::filesystem::path& path, std::vector<float>* shape) {
    const Result<std::string> text = readFile(path, kMaxProjectBytes);
    if (!text) {
        return Result<Project>::failure(text.diagnostics());
    }
    return readProject(text.value(), path.string(), shape);
}

bool isProjectFile(const std::filesystem::path& path) {
    return lowerExtension(path) == kProjectExtension;
}

CompileOptions optionsOf(const Project& project, const machine::ProfileLibrary& machines) {
    machine::Program named;
    named.header.machine = project.machine;
    auto machine = machine::chooseProfile(named, machines);
    return {.castOn = project.castOn,
            .ending = project.ending,
            .firstNeedle = project.firstNeedle,
            .machine = machine ? std::move(machine).value() : machine::genericProfile()};
}

Result<machine::Program> readAnyProgram(const std::filesystem::path& path) {
    if (!isProjectFile(path)) {
        return formats::readProgram(path);
    }
    const Result<Project> project = readProjectFile(path);
    if (!project) {
        return Result<machine::Program>::failure(project.diagnostics());
    }
    Diagnostics ignored; // whoever chooses the machine to check it on hears of them
    const auto machines = machine::ProfileLibrary::read(machine::profileFolders(), ignored);
    return compile(project.value().chart, optionsOf(project.value(), machines));
}

} // namespace knittsim::pattern
