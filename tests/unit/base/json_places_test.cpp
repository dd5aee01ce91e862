#include "core/base/json_places.h"

#include <gtest/gtest.h>

namespace knittsim {
namespace {

int lineOf(std::string_view text, const std::string& key) {
    Diagnostics problems{{"KS0004", Severity::Error, Place{.file = "x.json"}, {key, "1", "2"}}};
    tellLines(text, problems);
    return problems.front().place.line;
}

constexpr std::string_view kText = R"({
  "a": {"b": 1,
        "c": [10, {"d": 4},
              [5,
               6]
             ]},
  "a\"x": "}\n{",
  "e":
    7, "a.b": 1
})";

TEST(JsonPlaces, AKeyHasTheLineInWhichItStands) {
    EXPECT_EQ(lineOf(kText, "a"), 2);
    EXPECT_EQ(lineOf(kText, "a.c"), 3);
    EXPECT_EQ(lineOf(kText, "a.c.1.d"), 3);
    EXPECT_EQ(lineOf(kText, "a.c.2"), 4);
    EXPECT_EQ(lineOf(kText, "a.c.2.0"), 4);
    EXPECT_EQ(lineOf(kText, "a.c.2.1"), 5);
    EXPECT_EQ(lineOf(kText, "a\"x"), 7);
    EXPECT_EQ(lineOf(kText, "e"), 8);
}

TEST(JsonPlaces, WhatIsMissingHasTheLineOfWhatItIsMissingFrom) {
    EXPECT_EQ(lineOf(kText, "a.c.2.7.name"), 4);
    EXPECT_EQ(lineOf(kText, "nothing"), 1);
    EXPECT_EQ(lineOf("\n\n 5", "the file"), 3);
}

TEST(JsonPlaces, OtherFindingsStayAsTheyAre) {
    const Diagnostics before{{"KS0003", Severity::Error, Place{.file = "x.json", .line = 7}, {"a"}},
                             {"KS0004", Severity::Error, Place{.file = "x.json", .line = 9}, {"a"}},
                             {"KS0115", Severity::Error, Place{.file = "x.json"}, {"20"}}};
    Diagnostics after = before;
    tellLines(kText, after);
    EXPECT_EQ(after, before);
}

TEST(JsonPlaces, DeepTextIsNoTrouble) {
    const std::string deep = std::string(100000, '[') + std::string(100000, ']');
    EXPECT_EQ(lineOf(deep, "nothing"), 1);
}

} // namespace
} // namespace knittsim
