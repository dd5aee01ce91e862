#include "core/base/json_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace knittsim {
namespace {

using testing::ElementsAre;
using testing::Field;

TEST(ParseJson, TellsThePlaceOfAFault) {
    const auto result = parseJson("{\n  \"a\": 1,\n  \"b\" 2\n}", "a.json");
    ASSERT_EQ(result.diagnostics().size(), 1u);
    EXPECT_EQ(result.diagnostics()[0].id, "KS0003");
    EXPECT_EQ(result.diagnostics()[0].place.file, "a.json");
    EXPECT_EQ(result.diagnostics()[0].place.line, 3);
}

TEST(JsonReader, ReportsEveryProblemInOnePass) {
    const auto json = parseJson(R"({"n": "x", "big": 11, "odd": 1, "in": {"t": ""}, "kind": "c"})", "a.json");
    ASSERT_TRUE(json);
    Diagnostics diagnostics;
    JsonReader reader(json.value(), "a.json", diagnostics);
    reader.number("n", 0, 1);
    reader.integer("big", 0, 10);
    reader.flag("missing");
    reader.object("in").text("t");
    reader.choice("kind", {"a", "b"});
    reader.rejectUnknownKeys();
    const auto problem = [](const char* id, const char* key) {
        return testing::AllOf(Field(&Diagnostic::id, id),
                              Field(&Diagnostic::arguments, testing::Contains(std::string(key))));
    };
    EXPECT_THAT(diagnostics,
                ElementsAre(problem("KS0004", "n"), problem("KS0004", "big"), problem("KS0005", "missing"),
                            problem("KS0004", "in.t"), problem("KS0004", "kind"), problem("KS0004", "odd")));
}

TEST(JsonReader, GivesGoodValuesWithoutAWord) {
    const auto json = parseJson(R"({"n": 0.5, "i": 3, "f": true, "t": "x", "a": [1, 2]})", "a.json");
    ASSERT_TRUE(json);
    Diagnostics diagnostics;
    JsonReader reader(json.value(), "a.json", diagnostics);
    EXPECT_EQ(reader.number("n", 0, 1), 0.5);
    EXPECT_EQ(reader.integer("i", 3, 3), 3);
    EXPECT_TRUE(reader.flag("f"));
    EXPECT_EQ(reader.text("t"), "x");
    EXPECT_EQ(reader.array("a", 2, 2).size(), 2u);
    EXPECT_FALSE(reader.has("none"));
    reader.rejectUnknownKeys();
    EXPECT_TRUE(diagnostics.empty());
}

} // namespace
} // namespace knittsim
