#include "core/lesson/lesson.h"

#include "core/base/file.h"
#include "core/base/json_places.h"
#include "core/base/json_reader.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace knittsim::lesson {

namespace {

using machine::OperationIndex;
using machine::OperationKind;

constexpr std::size_t kMaxLessonBytes = std::size_t{1} << 20;
constexpr std::size_t kMaxStops = 200;
constexpr int kMaxNumber = 100'000'000;
constexpr std::array<std::pair<std::string_view, Look>, 4> kLooks{
    {{"beds", Look::Beds}, {"fabric", Look::Fabric}, {"chart", Look::Chart}, {"source", Look::Source}}};

bool isLanguage(const std::string& key) {
    return key.size() == 2 && std::ranges::all_of(key, [](unsigned char c) { return std::islower(c) != 0; });
}

Words readWords(JsonReader reader) {
    Words words;
    words.byLanguage["en"] = reader.text("en");
    for (const std::string& key : reader.keys()) {
        if (isLanguage(key)) {
            words.byLanguage[key] = reader.text(key);
        }
    }
    reader.rejectUnknownKeys();
    return words;
}

std::vector<std::string> kindNames() {
    std::vector<std::string> names;
    for (int i = 0; i < machine::kOperationKindCount; ++i) {
        names.emplace_back(toString(static_cast<OperationKind>(i)));
    }
    return names;
}

Where readWhere(JsonReader reader) {
    Where where;
    if (reader.has("line")) {
        where = {Where::Kind::Line, reader.integer("line", 1, kMaxNumber)};
    } else if (reader.has("course")) {
        where = {Where::Kind::Course, reader.integer("course", 0, kMaxNumber)};
    } else if (reader.has("kind")) {
        const std::vector<std::string> names = kindNames();
        const auto found = std::ranges::find(names, reader.choice("kind", names));
        const int number = reader.has("number") ? reader.integer("number", 1, kMaxNumber) : 1;
        where = {Where::Kind::Nth, number,
                 static_cast<OperationKind>(found == names.end() ? 0 : found - names.begin())};
    } else if (reader.has("end")) {
        if (!reader.flag("end")) {
            reader.report("end", "false", "true");
        }
        where.kind = Where::Kind::End;
    } else {
        where = {Where::Kind::Operation, reader.integer("operation", 0, kMaxNumber)};
    }
    reader.rejectUnknownKeys();
    return where;
}

Stop readStop(JsonReader reader) {
    Stop stop;
    stop.at = readWhere(reader.object("at"));
    stop.title = readWords(reader.object("title"));
    stop.text = readWords(reader.object("text"));
    std::vector<std::string> names;
    for (const auto& [name, look] : kLooks) {
        names.emplace_back(name);
    }
    const auto found = std::ranges::find(names, reader.choice("look", names));
    stop.look =
        found == names.end() ? Look::Beds : kLooks[static_cast<std::size_t>(found - names.begin())].second;
    reader.rejectUnknownKeys();
    return stop;
}

} // namespace

const std::string& Words::in(std::string_view language) const {
    static const std::string none;
    const auto found = byLanguage.find(std::string(language.substr(0, 2)));
    const auto english = byLanguage.find("en");
    return found != byLanguage.end() ? found->second : english != byLanguage.end() ? english->second : none;
}

Result<Lesson> parseLesson(std::string_view text, const std::filesystem::path& file) {
    const Result<nlohmann::json> json = parseJson(text, file.string());
    if (!json) {
        return Result<Lesson>::failure(json.diagnostics());
    }
    Diagnostics problems;
    JsonReader reader(json.value(), file.string(), problems);
    Lesson lesson;
    lesson.id = file.stem().string();
    lesson.title = readWords(reader.object("title"));
    lesson.summary = readWords(reader.object("summary"));
    if (reader.has("file")) {
        lesson.file = file.parent_path() / reader.text("file");
    } else {
        lesson.sample = reader.text("sample");
    }
    const std::vector<nlohmann::json> stops = reader.array("stops", 1, kMaxStops);
    for (std::size_t i = 0; i < stops.size(); ++i) {
        lesson.stops.push_back(
            readStop(JsonReader(stops[i], file.string(), problems, "stops." + std::to_string(i))));
    }
    reader.rejectUnknownKeys();
    if (hasErrors(problems)) {
        tellLines(text, problems);
        return Result<Lesson>::failure(problems);
    }
    return {std::move(lesson), std::move(problems)};
}

Result<Lesson> readLesson(const std::filesystem::path& file) {
    const Result<std::string> text = readFile(file, kMaxLessonBytes);
    if (!text) {
        return Result<Lesson>::failure(text.diagnostics());
    }
    return parseLesson(text.value(), file);
}

std::vector<Lesson> readLessons(const std::filesystem::path& folder, Diagnostics& problems) {
    std::vector<Lesson> lessons;
    for (const std::filesystem::path& file : jsonFiles(folder)) {
        Result<Lesson> lesson = readLesson(file);
        problems.insert(problems.end(), lesson.diagnostics().begin(), lesson.diagnostics().end());
        if (lesson) {
            lessons.push_back(std::move(lesson).value());
        }
    }
    return lessons;
}

OperationIndex stepOf(const Where& where, const machine::Program& program,
                      std::span<const OperationIndex> courseEnds) {
    const auto& operations = program.operations;
    const auto end = static_cast<OperationIndex>(operations.size());
    const auto after = [&](auto found) {
        return found == operations.end() ? end : static_cast<OperationIndex>(found - operations.begin()) + 1;
    };
    switch (where.kind) {
    case Where::Kind::Operation:
        return std::min(where.number, end);
    case Where::Kind::Line:
        return after(
            std::ranges::find_if(operations, [&](const auto& op) { return op.line >= where.number; }));
    case Where::Kind::Course:
        return where.number == 0 ? 0
               : where.number <= static_cast<int>(courseEnds.size())
                   ? courseEnds[static_cast<std::size_t>(where.number) - 1]
                   : end;
    case Where::Kind::Nth: {
        int seen = 0;
        return after(std::ranges::find_if(operations, [&](const auto& op) {
            return op.kind == where.operation && ++seen == where.number;
        }));
    }
    case Where::Kind::End:
        break;
    }
    return end;
}

} // namespace knittsim::lesson
