#include "core/base/message_table.h"
#include "core/lesson/lesson.h"
#include "core/pattern/samples.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fstream>
#include <functional>
#include <map>

namespace knittsim::lesson {
namespace {

using machine::OperationKind;
using nlohmann::json;

const std::filesystem::path kFolder = std::filesystem::path(KNITTSIM_SOURCE_DIR) / "resources/lessons";

json small() {
    return json::parse(R"({
        "title": {"en": "Title", "de": "Titel"},
        "summary": {"en": "Summary"},
        "sample": "plain",
        "stops": [{"at": {"kind": "knit", "number": 2}, "title": {"en": "One"}, "text": {"en": "Text"}, "look": "beds"}]
    })");
}

/// "KS0005 stops.0.at.operation", or nothing.
std::string problemOf(const json& lesson) {
    const auto result = parseLesson(lesson.dump(), "folder/mine.json");
    return result ? std::string()
                  : result.diagnostics().front().id + ' ' + result.diagnostics().front().arguments.front();
}

TEST(Lesson, IsReadWithAllItsWords) {
    const auto lesson = parseLesson(small().dump(), "folder/mine.json");
    ASSERT_TRUE(lesson);
    EXPECT_EQ(lesson.value().id, "mine");
    EXPECT_EQ(lesson.value().title.in("de_AT"), "Titel");
    EXPECT_EQ(lesson.value().title.in("fr"), "Title");
    EXPECT_EQ(lesson.value().summary.in("de"), "Summary");
    ASSERT_EQ(lesson.value().stops.size(), 1U);
    EXPECT_EQ(lesson.value().stops.front().at, (Where{Where::Kind::Nth, 2, OperationKind::Knit}));
    EXPECT_EQ(lesson.value().stops.front().look, Look::Beds);
}

TEST(Lesson, AFileLiesBesideTheLesson) {
    json lesson = small();
    lesson.erase("sample");
    lesson["file"] = "program.k";
    const auto read = parseLesson(lesson.dump(), "folder/mine.json");
    ASSERT_TRUE(read);
    EXPECT_EQ(read.value().file, std::filesystem::path("folder/program.k"));
}

TEST(Lesson, WhatIsWrongIsNamed) {
    const std::vector<std::pair<std::function<void(json&)>, std::string>> faults{
        {[](json& l) { l.erase("title"); }, "KS0005 title"},
        {[](json& l) { l["title"].erase("en"); }, "KS0005 title.en"},
        {[](json& l) { l["title"]["german"] = "x"; }, "KS0004 title.german"},
        {[](json& l) { l.erase("sample"); }, "KS0005 sample"},
        {[](json& l) { l["file"] = "x.k"; }, "KS0004 sample"},
        {[](json& l) { l["stops"] = json::array(); }, "KS0004 stops"},
        {[](json& l) { l["stops"][0]["at"] = json::object(); }, "KS0005 stops.0.at.operation"},
        {[](json& l) { l["stops"][0]["at"]["kind"] = "purl"; }, "KS0004 stops.0.at.kind"},
        {[](json& l) { l["stops"][0]["at"]["number"] = 0; }, "KS0004 stops.0.at.number"},
        {[](json& l) { l["stops"][0]["at"]["line"] = 1; }, "KS0004 stops.0.at.kind"},
        {[](json& l) { l["stops"][0]["look"] = "sky"; }, "KS0004 stops.0.look"},
        {[](json& l) { l["more"] = 1; }, "KS0004 more"}};
    for (const auto& [spoil, expected] : faults) {
        json lesson = small();
        spoil(lesson);
        EXPECT_EQ(problemOf(lesson), expected);
    }
    EXPECT_EQ(parseLesson("{", "x.json").diagnostics().front().id, "KS0003");
    EXPECT_EQ(readLesson("/nowhere/x.json").diagnostics().front().id, "KS0001");
}

TEST(Lesson, WhatIsWrongHasItsLine) {
    const auto broken = parseLesson(R"({
        "title": {"en": "Title"},
        "summary": {"en": "Summary", "german": "x"},
        "sample": "plain",
        "stops": [
            {"at": {"end": true}, "title": {"en": "One"}, "text": {"en": "Text"}, "look": "beds"},
            {"at": {"kind": "purl"},
             "title": {"en": "Two"},
             "look": "beds"}
        ]
    })",
                                    "mine.json");
    ASSERT_FALSE(broken);
    std::map<std::string, int> lines;
    for (const Diagnostic& problem : broken.diagnostics()) {
        EXPECT_EQ(problem.place.file, "mine.json");
        lines[problem.arguments.front()] = problem.place.line;
    }
    EXPECT_EQ(lines, (std::map<std::string, int>{
                         {"summary.german", 3}, {"stops.1.at.kind", 7}, {"stops.1.text", 7}}));
}

TEST(Lesson, APlaceIsTheStepAfterItsOperation) {
    machine::Program program;
    for (const int line : {3, 4, 7}) {
        machine::Operation op;
        op.kind = line == 4 ? OperationKind::Xfer : OperationKind::Knit;
        op.line = line;
        program.operations.push_back(op);
    }
    const std::vector<machine::OperationIndex> courses{1, 3};
    const auto step = [&](Where where) { return stepOf(where, program, courses); };
    EXPECT_EQ(step({Where::Kind::Operation, 0}), 0);
    EXPECT_EQ(step({Where::Kind::Operation, 99}), 3);
    EXPECT_EQ(step({Where::Kind::Line, 4}), 2);
    EXPECT_EQ(step({Where::Kind::Line, 5}), 3);
    EXPECT_EQ(step({Where::Kind::Course, 0}), 0);
    EXPECT_EQ(step({Where::Kind::Course, 1}), 1);
    EXPECT_EQ(step({Where::Kind::Course, 9}), 3);
    EXPECT_EQ(step({Where::Kind::Nth, 2, OperationKind::Knit}), 3);
    EXPECT_EQ(step({Where::Kind::Nth, 1, OperationKind::Xfer}), 2);
    EXPECT_EQ(step({Where::Kind::End}), 3);
}

TEST(Lesson, ThoseThatComeAlongAreEightInTwoLanguagesWithStopsThatRise) {
    Diagnostics problems;
    const std::vector<Lesson> lessons = readLessons(kFolder, problems);
    EXPECT_TRUE(problems.empty()) << toLine(problems.front());
    ASSERT_EQ(lessons.size(), 8U);
    for (const Lesson& lesson : lessons) {
        const machine::Program program = pattern::makeSample(lesson.sample);
        ASSERT_FALSE(program.operations.empty()) << lesson.id;
        machine::OperationIndex last = -1;
        for (const Stop& stop : lesson.stops) {
            EXPECT_NE(stop.text.in("en"), stop.text.in("de")) << lesson.id;
            EXPECT_FALSE(stop.title.in("de").empty());
            if (stop.at.kind != Where::Kind::Course) {
                const auto step = stepOf(stop.at, program, {});
                EXPECT_GT(step, last) << lesson.id << ": " << stop.title.in("en");
                const bool isEnd = stop.at.kind == Where::Kind::End;
                EXPECT_EQ(isEnd, step == static_cast<int>(program.operations.size())) << lesson.id;
                last = step;
            }
        }
    }
}

TEST(Lesson, TheSchemaNamesTheSameKeys) {
    std::ifstream in(kFolder / "lesson.schema.json");
    const json schema = json::parse(in);
    const json stop = schema["properties"]["stops"]["items"];
    for (const auto& key : stop["required"]) {
        json lesson = small();
        lesson["stops"][0].erase(key.get<std::string>());
        EXPECT_EQ(problemOf(lesson).substr(0, 14), "KS0005 stops.0") << key;
    }
    for (const auto& look : stop["properties"]["look"]["enum"]) {
        json lesson = small();
        lesson["stops"][0]["look"] = look;
        EXPECT_EQ(problemOf(lesson), "");
    }
    const std::map<std::string, json> values{{"operation", 5}, {"line", 5},   {"course", 5},
                                             {"kind", "rack"}, {"number", 2}, {"end", true}};
    for (const auto& [key, part] : schema["$defs"]["where"]["properties"].items()) {
        json lesson = small();
        lesson["stops"][0]["at"] = {{key, values.at(key)}};
        if (key == "number") {
            lesson["stops"][0]["at"]["kind"] = "rack";
        }
        EXPECT_EQ(problemOf(lesson), "") << key;
    }
}

} // namespace
} // namespace knittsim::lesson
