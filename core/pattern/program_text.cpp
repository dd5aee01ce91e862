#include "core/pattern/program_text.h"

#include "core/formats/knitout/reader.h"
#include "core/formats/knitout/writer.h"
#include "core/pattern/cell_letters.h"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

namespace knittsim::pattern {

using nlohmann::json;

namespace {

/// Carriers that are called like the yarns.
machine::Program emptyProgram() {
    machine::Program program;
    for (std::size_t yarn = 0; yarn < kMaxChartYarns; ++yarn) {
        program.header.carriers.push_back(
            {std::string(1, yarnDigit(yarn)), static_cast<int>(yarn), false, {}});
    }
    return program;
}

std::string loopDigits(const std::vector<std::uint8_t>& loops) {
    std::string text;
    for (const std::uint8_t beds : loops) {
        text += fmt::format("{:x}", beds & 15U);
    }
    return text;
}

/// A value for each letter; empty where one is not of `letters`.
std::vector<std::uint8_t> valuesOf(const std::string& text, std::string_view letters) {
    std::vector<std::uint8_t> values;
    for (const char letter : text) {
        const std::size_t value = letters.find(letter);
        if (value == std::string_view::npos) {
            return {};
        }
        values.push_back(static_cast<std::uint8_t>(value));
    }
    return values;
}

bool isInside(const ProgramCourse& course, const Chart& chart) {
    const auto inside = [&](machine::Needle needle) {
        return needle.index >= 0 && needle.index < chart.width;
    };
    return std::ranges::all_of(course.operations, [&](const machine::Operation& op) {
        return (!namesNeedle(op.kind) || inside(op.needle)) && (!namesTarget(op.kind) || inside(op.target)) &&
               std::ranges::all_of(op.carriers, [&](int yarn) {
                   return static_cast<std::size_t>(yarn) < chart.yarns.size();
               });
    });
}

bool readOperations(JsonReader& reader, ProgramCourse& course) {
    std::string text = formats::knitout::write(emptyProgram());
    for (const json& line : reader.array("operations", 0, 1'000'000)) {
        if (!line.is_string()) {
            reader.report("operations", "something else", "lines of knitout");
            return false;
        }
        text += line.get<std::string>() + '\n';
    }
    auto parsed = formats::knitout::parse(text, {});
    if (!parsed) {
        const Diagnostic& problem = parsed.diagnostics().front();
        reader.report("operations",
                      problem.id + (problem.arguments.empty() ? "" : " " + problem.arguments.front()),
                      "lines of knitout");
        return false;
    }
    course.operations = std::move(parsed.value().operations);
    course.texts = std::move(parsed.value().texts);
    for (machine::Operation& op : course.operations) {
        op.line = -1;
    }
    return true;
}

} // namespace

std::string programText(const ProgramCourse& course) {
    machine::Program program = emptyProgram();
    program.operations = course.operations;
    program.texts = course.texts;
    std::string in;
    for (const std::uint8_t yarn : course.in) {
        in += yarnDigit(yarn);
    }
    std::string text = fmt::format(
        R"({{"stitches": "{}", "yarns": "{}", "moves": {}, "loops": "{}", "in": "{}", "rack": {}, "operations": [)",
        stitchLetters(course.cells), yarnDigits(course.cells), movesText(course.moves),
        loopDigits(course.loops), in, course.rack);
    std::istringstream lines(formats::knitout::write(program));
    bool first = true;
    for (std::string line; std::getline(lines, line);) {
        if (!line.empty() && line[0] != ';') {
            text += (first ? "" : ", ") + json(line).dump(-1, ' ', false, json::error_handler_t::replace);
            first = false;
        }
    }
    return text + "]}";
}

std::shared_ptr<const ProgramCourse> readProgramCourse(JsonReader& reader, const Chart& chart) {
    auto course = std::make_shared<ProgramCourse>();
    const auto wales = static_cast<std::size_t>(chart.width);
    course->cells.resize(wales);
    if (!readCells(reader, course->cells)) {
        return nullptr;
    }
    course->moves = readMoves(reader);
    course->loops = valuesOf(reader.text("loops"), "0123456789abcdef");
    course->in = valuesOf(reader.optionalText("in"), "0123456789abcdefghijklmnopqrstuvwxyz");
    course->rack = reader.number("rack", -1000, 1000);
    const bool read = readOperations(reader, *course);
    reader.rejectUnknownKeys();
    if (course->loops.size() != wales) {
        reader.report("loops", "another text", fmt::format("{} hexadecimal digits", wales));
        return nullptr;
    }
    const auto isMove = [&](const LoopMove& m) {
        return m.from >= 0 && m.from < chart.width && m.to >= 0 && m.to < chart.width;
    };
    if (read && (!isInside(*course, chart) || !std::ranges::all_of(course->moves, isMove))) {
        reader.report("operations", "a needle or a yarn that the chart has not",
                      "wales and yarns of the chart");
        return nullptr;
    }
    return read ? course : nullptr;
}

} // namespace knittsim::pattern
