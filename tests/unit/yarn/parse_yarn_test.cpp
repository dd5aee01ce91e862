#include "core/yarn/yarn_library.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <functional>

namespace knittsim::yarn {
namespace {

using nlohmann::json;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

json goodYarn() {
    return json::parse(R"({
        "id": "own", "name": "Own yarn", "fibre": "wool",
        "count": {"as_written": "Nm 2/30", "tex": 66.6667, "nm": 15, "ne": 8.858},
        "outer_diameter_mm": 0.36, "core_diameter_mm": 0.27,
        "axial_stiffness_n": 38, "bending_stiffness_n_m2": 8.7e-9, "friction": 0.22, "colour": "#E9dfc8",
        "surface": {"kind": "hairy", "hairiness": 0.3, "plies": 2, "twist_per_metre": -300, "melange": 0.5},
        "sources": {"friction": "guessed"}, "note": "soft"})");
}

Diagnostics problemsOf(const std::function<void(json&)>& spoil) {
    json yarn = goodYarn();
    spoil(yarn);
    const Result<Yarn> result = parseYarn(yarn.dump(), "own.json");
    EXPECT_FALSE(result);
    return result.diagnostics();
}

/// The one problem as "id key".
std::string problemOf(const std::function<void(json&)>& spoil) {
    const Diagnostics problems = problemsOf(spoil);
    EXPECT_THAT(problems, SizeIs(1));
    return problems.empty() ? "" : problems[0].id + ' ' + problems[0].arguments.at(0);
}

TEST(ParseYarn, ConvertsUnitsOfTheLiterature) {
    const Result<Yarn> result = parseYarn(goodYarn().dump(), "own.json");
    ASSERT_TRUE(result);
    const Yarn& yarn = result.value();
    EXPECT_EQ(yarn.axialStiffnessMilliNewton, 38'000);
    EXPECT_EQ(yarn.bendingStiffness, 8.7);
    EXPECT_EQ(yarn.colour, (Colour{0xe9, 0xdf, 0xc8}));
    EXPECT_EQ(yarn.surface.twistPerMetre, -300);
    EXPECT_EQ(yarn.sources.at("friction"), "guessed");
    EXPECT_NEAR(yarn.nm(), 15, 1e-4);
    EXPECT_NEAR(yarn.ne(), 8.858, 1e-3);
}

TEST(ParseYarn, WrittenYarnReadsBackTheSame) {
    const Result<Yarn> first = parseYarn(goodYarn().dump(), "own.json");
    ASSERT_TRUE(first);
    const Result<Yarn> second = parseYarn(toJson(first.value()), "own.json");
    ASSERT_TRUE(second);
    EXPECT_EQ(first.value(), second.value());
    EXPECT_EQ(toJson(first.value()), toJson(second.value()));
}

TEST(ParseYarn, SyntaxErrorTellsLineAndColumn) {
    const Result<Yarn> result = parseYarn("{\n  \"id\": \"a\",\n  \"name\": oops\n}", "own.json");
    ASSERT_FALSE(result);
    ASSERT_THAT(result.diagnostics(), SizeIs(1));
    const Diagnostic& problem = result.diagnostics()[0];
    EXPECT_EQ(problem.id, "KS0003");
    EXPECT_EQ(problem.place.file, "own.json");
    EXPECT_EQ(problem.place.line, 3);
    EXPECT_EQ(problem.place.column, 11);
    EXPECT_THAT(problem.arguments.at(0), ::testing::StartsWith("syntax error"));
}

TEST(ParseYarn, AnyBytesGiveADiagnostic) {
    using namespace std::string_literals;
    for (const std::string& text :
         {""s, "\xff\xfe"s, "\0"s, "[1, 2"s, "1e999"s, "\"\xc3\x28\""s, std::string(10'000, '[')}) {
        const Result<Yarn> result = parseYarn(text, "own.json");
        ASSERT_FALSE(result);
        const std::string& id = result.diagnostics().at(0).id;
        const char first = text.empty() ? 'x' : text[0];
        EXPECT_EQ(id, text.empty()      ? "KS0012"
                      : first == '\xff' ? "KS0013"
                      : first == '\0'   ? "KS0122"
                                        : "KS0003");
        for (const std::string& argument : result.diagnostics()[0].arguments) {
            for (const char c : argument) {
                EXPECT_LT(static_cast<unsigned char>(c), 0x80);
            }
        }
    }
}

TEST(ParseYarn, NoObject) {
    const Result<Yarn> result = parseYarn("[1]", "own.json");
    ASSERT_THAT(result.diagnostics(), SizeIs(1));
    EXPECT_THAT(result.diagnostics()[0].arguments, ElementsAre("the file", "array", "an object"));
}

TEST(ParseYarn, MissingWrongAndUnknownKeysAreNamedWithTheirPath) {
    EXPECT_EQ(problemOf([](json& y) { y.erase("friction"); }), "KS0005 friction");
    EXPECT_EQ(problemOf([](json& y) { y.erase("surface"); }), "KS0005 surface");
    EXPECT_EQ(problemOf([](json& y) { y["surface"].erase("plies"); }), "KS0005 surface.plies");
    EXPECT_EQ(problemOf([](json& y) { y["friction"] = "low"; }), "KS0004 friction");
    EXPECT_EQ(problemOf([](json& y) { y["surface"]["plies"] = 2.5; }), "KS0004 surface.plies");
    EXPECT_EQ(problemOf([](json& y) { y["surface"]["kind"] = "wet"; }), "KS0004 surface.kind");
    EXPECT_EQ(problemOf([](json& y) { y["surface"] = 3; }), "KS0004 surface");
    EXPECT_EQ(problemOf([](json& y) { y["name"] = ""; }), "KS0004 name");
    EXPECT_EQ(problemOf([](json& y) { y["colr"] = "#000000"; }), "KS0004 colr");
    EXPECT_EQ(problemOf([](json& y) { y["sources"]["tex"] = "?"; }), "KS0004 sources.tex");
}

TEST(ParseYarn, NumbersMustBePhysical) {
    EXPECT_EQ(problemOf([](json& y) { y["outer_diameter_mm"] = 0; }), "KS0004 outer_diameter_mm");
    EXPECT_EQ(problemOf([](json& y) { y["count"]["tex"] = -3; }), "KS0004 count.tex");
    EXPECT_EQ(problemOf([](json& y) { y["core_diameter_mm"] = 0.361; }), "KS0004 core_diameter_mm");
    EXPECT_EQ(problemOf([](json& y) { y["axial_stiffness_n"] = -1; }), "KS0004 axial_stiffness_n");
    EXPECT_EQ(problemOf([](json& y) { y["bending_stiffness_n_m2"] = 8.7; }), "KS0004 bending_stiffness_n_m2");
    EXPECT_EQ(problemOf([](json& y) { y["friction"] = 7; }), "KS0004 friction");
    EXPECT_EQ(problemOf([](json& y) { y["surface"]["melange"] = 1.1; }), "KS0004 surface.melange");
}

TEST(ParseYarn, CountsMustAgree) {
    EXPECT_EQ(problemOf([](json& y) { y["count"]["nm"] = 30; }), "KS0004 count.nm");
    EXPECT_EQ(problemOf([](json& y) { y["count"]["ne"] = 15; }), "KS0004 count.ne");
}

TEST(ParseYarn, ColourMustBeSixHexDigits) {
    for (const char* colour : {"e9dfc8", "#e9dfc", "#e9dfg8", "#e9dfc8ff", "red"}) {
        EXPECT_EQ(problemOf([&](json& y) { y["colour"] = colour; }), "KS0004 colour") << colour;
    }
}

TEST(ParseYarn, ReportsAllProblemsAtOnce) {
    EXPECT_THAT(problemsOf([](json& y) {
                    y.erase("name");
                    y["friction"] = true;
                    y["surface"]["hairiness"] = 2;
                    y["weight"] = 1;
                }),
                SizeIs(4));
}

} // namespace
} // namespace knittsim::yarn
