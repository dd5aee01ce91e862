#include "core/pattern/project.h"
#include "core/pattern/sample_charts.h"
#include "core/pattern/samples.h"
#include "core/pattern/swatch.h"

#include <gtest/gtest.h>

namespace knittsim::pattern {
namespace {

TEST(Project, WhatIsWrittenIsReadAgain) {
    for (const Sample& sample : samples()) {
        Project project{sampleChart(sample.id), CastOn::Open, Ending::Dropped, "kniterate"};
        const auto read = readProject(writeProject(project), "a.knitt");
        ASSERT_TRUE(read) << sample.id << ' ' << read.diagnostics().front().arguments.front();
        EXPECT_EQ(read.value(), project) << sample.id;
    }
}

TEST(Project, ACourseIsALine) {
    const std::string text = writeProject({plainChart(5, 7), CastOn::Open, Ending::Held, {}});
    std::size_t lines = 0;
    for (std::size_t at = text.find("{\"stitches\""); at != std::string::npos;
         at = text.find("\n{\"stitches\"", at + 1)) {
        ++lines;
    }
    EXPECT_EQ(lines, 7U);
}

std::string idOf(const std::string& text) {
    const auto read = readProject(text, "a.knitt");
    return read ? std::string("fine") : read.diagnostics().front().id;
}

TEST(Project, TellsWhatIsWrong) {
    Chart chart = plainChart(3, 2);
    const std::string good = writeProject({chart, CastOn::Open, Ending::Held, {}});
    const auto with = [&](const std::string& from, const std::string& to) {
        std::string text = good;
        text.replace(text.find(from), from.size(), to);
        return idOf(text);
    };
    EXPECT_EQ(idOf(good), "fine");
    EXPECT_EQ(with("\"knitt\": 2", "\"knitt\": 3"), "KS0509");
    EXPECT_EQ(with("\"kkk\"", "\"kk\""), "KS0004");
    EXPECT_EQ(with("\"kkk\"", "\"kxk\""), "KS0004");
    EXPECT_EQ(with("\"yarns\": \"0\"", "\"yarns\": \"4\""), "fine"); // it can be mended
    EXPECT_EQ(with("\"yarns\": \"0\"", "\"yarns\": \"0\", \"moves\": [[0, 99999999999]]"), "KS0503");
    EXPECT_EQ(with("\"yarns\": \"0\"", "\"yarns\": \"0\", \"moves\": [[0.5, 1]]"), "KS0004");
    EXPECT_EQ(with("\"wales\": 3", "\"wales\": 3000000"), "KS0004");
    EXPECT_EQ(idOf(good.substr(0, good.size() / 2)), "KS0003");
    EXPECT_EQ(idOf("[1]"), "KS0004");
}

TEST(Project, AFileOfVersion1IsReadAndBecomesVersion2) {
    const std::string old = R"({"knitt": 1, "cast_on": "open", "ending": "held", "beds": "single", "wales": 3,
        "yarns": [{"carrier": "1", "colour": "#102030", "library_id": "linen-26"}],
        "courses": [{"stitches": "kpk", "yarns": "0"}]})";
    const auto read = readProject(old, "a.knitt");
    ASSERT_TRUE(read);
    EXPECT_TRUE(read.value().colourways.all.empty());
    EXPECT_EQ(read.value().chart.at(1, 0).stitch, Stitch::Purl);
    const std::string now = writeProject(read.value());
    EXPECT_NE(now.find("\"knitt\": 2"), std::string::npos);
    const auto again = readProject(now, "a.knitt");
    ASSERT_TRUE(again);
    EXPECT_EQ(again.value(), read.value());
}

Project inTwoColourways() {
    Project project{.chart = plainChart(3, 2), .machine = {}};
    project.chart.yarns = {{"1", {1, 2, 3}, "linen-26"}, {"2", {4, 5, 6}, ""}};
    addColourway(project.colourways, project.chart, "night", "day");
    project.chart.yarns[0].colour = {9, 9, 9};
    return project;
}

TEST(Colourways, KeepWhatEachHas) {
    Project project = inTwoColourways();
    EXPECT_EQ(project.colourways.used, 1);
    useColourway(project.colourways, project.chart, 0);
    EXPECT_EQ(project.chart.yarns[0].colour, (yarn::Colour{1, 2, 3}));
    useColourway(project.colourways, project.chart, 1);
    EXPECT_EQ(project.chart.yarns[0].colour, (yarn::Colour{9, 9, 9}));
    EXPECT_EQ(project.chart.yarns[1].colour, (yarn::Colour{4, 5, 6}));
}

TEST(Colourways, AYarnThatCameLaterKeepsItsColour) {
    Project project = inTwoColourways();
    project.chart.yarns.push_back({"3", {7, 7, 7}, ""});
    useColourway(project.colourways, project.chart, 0);
    EXPECT_EQ(project.chart.yarns[2].colour, (yarn::Colour{7, 7, 7}));
}

TEST(Colourways, TheOneInUseMayGoTheLastOneStays) {
    Project project = inTwoColourways();
    removeColourway(project.colourways, project.chart, 1);
    ASSERT_EQ(project.colourways.all.size(), 1U);
    EXPECT_EQ(project.colourways.used, 0);
    EXPECT_EQ(project.chart.yarns[0].colour, (yarn::Colour{1, 2, 3}));
    removeColourway(project.colourways, project.chart, 0);
    EXPECT_EQ(project.colourways.all.size(), 1U);
}

TEST(Colourways, AreInTheFileWithWhatTheChartHasNow) {
    const Project project = inTwoColourways();
    const auto read = readProject(writeProject(project, "QUJD"), "a.knitt");
    ASSERT_TRUE(read);
    ASSERT_EQ(read.value().colourways.all.size(), 2U);
    EXPECT_EQ(read.value().colourways.used, 1);
    EXPECT_EQ(read.value().colourways.all[0].name, "day");
    EXPECT_EQ(read.value().colourways.all[1].yarns, project.chart.yarns);
    EXPECT_EQ(read.value().chart, project.chart);
    std::string text = writeProject(project);
    text.replace(text.find("\"colourway\": 1"), 14, "\"colourway\": 2");
    EXPECT_EQ(idOf(text), "KS0004");
}

} // namespace
} // namespace knittsim::pattern
