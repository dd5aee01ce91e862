#include "core/pattern/project.h"
#include "core/pattern/sample_charts.h"
#include "core/pattern/samples.h"
#include "core/pattern/swatch.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <random>
#include <string_view>

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
    EXPECT_EQ(with("\"knitt\": 4", "\"knitt\": 5"), "KS0509");
    EXPECT_EQ(with("\"kkk\"", "\"kk\""), "KS0004");
    EXPECT_EQ(with("\"kkk\"", "\"kxk\""), "KS0004");
    EXPECT_EQ(with("\"yarns\": \"0\"", "\"yarns\": \"4\""), "fine"); // it can be mended
    EXPECT_EQ(with("\"yarns\": \"0\"", "\"yarns\": \"0\", \"moves\": [[0, 99999999999]]"), "KS0503");
    EXPECT_EQ(with("\"yarns\": \"0\"", "\"yarns\": \"0\", \"moves\": [[0.5, 1]]"), "KS0004");
    EXPECT_EQ(with("\"wales\": 3", "\"wales\": 3000000"), "KS0004");
    EXPECT_EQ(idOf(good.substr(0, good.size() / 2)), "KS0003");
    EXPECT_EQ(idOf("[1]"), "KS0004");
}

TEST(Project, TellsTheLineOfWhatIsWrong) {
    const std::string good = writeProject({plainChart(3, 4), CastOn::Open, Ending::Held, {}});
    const auto lineOf = [&](std::string_view from, const std::string& to, std::size_t which) {
        std::size_t at = good.find(from);
        for (; which > 0; --which) {
            at = good.find(from, at + 1);
        }
        std::string text = good;
        text.replace(at, from.size(), to);
        const auto read = readProject(text, "a.knitt");
        const int found = read ? -1 : read.diagnostics().front().place.line;
        return std::pair(found, 1 + static_cast<int>(std::count(
                                        good.begin(), good.begin() + static_cast<std::ptrdiff_t>(at), '\n')));
    };
    for (const auto& [found, wanted] :
         {lineOf("\"kkk\"", "\"kxk\"", 2), lineOf("\"yarns\": \"0\"", "\"yarns\": 7", 3),
          lineOf("\"ending\": \"", "\"ending\": \"un", 0)}) {
        EXPECT_EQ(found, wanted);
    }
}

TEST(Project, AFileOfVersion1IsReadAndBecomesTheNewest) {
    const std::string old = R"({"knitt": 1, "cast_on": "open", "ending": "held", "beds": "single", "wales": 3,
        "yarns": [{"carrier": "1", "colour": "#102030", "library_id": "linen-26"}],
        "courses": [{"stitches": "kpk", "yarns": "0"}]})";
    const auto read = readProject(old, "a.knitt");
    ASSERT_TRUE(read);
    EXPECT_TRUE(read.value().colourways.all.empty());
    EXPECT_EQ(read.value().chart.at(1, 0).stitch, Stitch::Purl);
    const std::string now = writeProject(read.value());
    EXPECT_NE(now.find("\"knitt\": 4"), std::string::npos);
    const auto again = readProject(now, "a.knitt");
    ASSERT_TRUE(again);
    EXPECT_EQ(again.value(), read.value());
}

TEST(Project, KeepsTheShapeToAMicrometre) {
    const Project project{plainChart(3, 2), CastOn::Open, Ending::Held, {}};
    const std::vector<float> shape{0.0F, -1.2345F, 30.5F, 1.0F, 2.0F, 3.0F};
    std::vector<float> back;
    const auto read = readProject(writeProject(project, {.shape = shape}), "a.knitt", &back);
    ASSERT_TRUE(read);
    EXPECT_EQ(read.value(), project);
    ASSERT_EQ(back.size(), shape.size());
    for (std::size_t i = 0; i < shape.size(); ++i) {
        EXPECT_NEAR(back[i], shape[i], 0.0006);
    }
    EXPECT_EQ(writeProject(project).find("shape"), std::string::npos) << "it is optional";
    std::string bad = writeProject(project, {.shape = shape});
    bad.replace(bad.find("30500"), 5, "null");
    EXPECT_EQ(idOf(bad), "KS0004");
}

TEST(Project, AFileOfVersion3HasNoShapeAndBecomesTheNewest) {
    std::string old = writeProject({plainChart(3, 2), CastOn::Open, Ending::Held, {}});
    old.replace(old.find("\"knitt\": 4"), 10, "\"knitt\": 3");
    std::vector<float> shape{1, 2, 3};
    const auto read = readProject(old, "a.knitt", &shape);
    ASSERT_TRUE(read);
    EXPECT_NE(writeProject(read.value()).find("\"knitt\": 4"), std::string::npos);
}

/// Bytes are changed, put in and taken out at random.
TEST(Project, DamagedFilesAreReadAsSomethingWholeOrRefusedInWords) {
    Chart chart = plainChart(5, 4);
    chart.course(2).moves = cross(0, 2, 2, Front::Left);
    const std::string good =
        writeProject({chart, CastOn::Open, Ending::Held, "kniterate"}, {.shape = {1, 2, 3, 4, 5, 6}});
    std::mt19937 random(5);
    const auto upTo = [&](std::size_t most) {
        return std::uniform_int_distribution<std::size_t>(0, most)(random);
    };
    int read = 0;
    for (int i = 0; i < 3000; ++i) {
        std::string text = good;
        for (std::size_t changes = 1 + upTo(2); changes > 0; --changes) {
            const std::size_t at = upTo(text.size() - 1);
            static constexpr std::string_view kBytes = "0123456789-.,:[]{}\"kptmb e\\\xff";
            const char byte = kBytes[upTo(kBytes.size() - 1)];
            switch (upTo(3)) {
            case 0:
                text[at] = byte;
                break;
            case 1:
                text.insert(at, 1, byte);
                break;
            case 2:
                text.erase(at, 1 + upTo(20));
                break;
            default:
                text.insert(at, text.substr(upTo(text.size() - 1), upTo(30)));
                break;
            }
        }
        std::vector<float> shape;
        const auto back = readProject(text, "a.knitt", &shape);
        if (!back) {
            ASSERT_FALSE(back.diagnostics().empty()) << text;
            continue;
        }
        ++read;
        const auto again = readProject(writeProject(back.value(), {.shape = shape}), "a.knitt");
        ASSERT_TRUE(again) << text;
        ASSERT_EQ(again.value(), back.value()) << text;
    }
    EXPECT_GT(read, 30);
    EXPECT_LT(read, 2900);
}

TEST(Project, AFileOfVersion2NamesTheRearBedOfItsTucksAndMisses) {
    const std::string old = R"({"knitt": 2, "cast_on": "open", "ending": "held", "beds": "double", "wales": 4,
        "yarns": [{"carrier": "1", "colour": "#102030", "library_id": ""}],
        "courses": [{"stitches": "ppkb", "yarns": "0"}, {"stitches": "tmtm", "yarns": "0"}]})";
    const auto read = readProject(old, "a.knitt");
    ASSERT_TRUE(read);
    const Chart& chart = read.value().chart;
    EXPECT_EQ(chart.at(0, 1).stitch, Stitch::RearTuck);
    EXPECT_EQ(chart.at(1, 1).stitch, Stitch::RearMiss);
    EXPECT_EQ(chart.at(2, 1).stitch, Stitch::Tuck);
    EXPECT_EQ(chart.at(3, 1).stitch, Stitch::Miss);
    const auto again = readProject(writeProject(read.value()), "a.knitt");
    ASSERT_TRUE(again);
    EXPECT_EQ(again.value(), read.value());
}

TEST(Project, AFileOfVersion1OnOneBedKeepsItsTucks) {
    const std::string old = R"({"knitt": 1, "cast_on": "open", "ending": "held", "beds": "single", "wales": 1,
        "yarns": [{"carrier": "1", "colour": "#102030", "library_id": ""}],
        "courses": [{"stitches": "p", "yarns": "0"}, {"stitches": "t", "yarns": "0"}]})";
    const auto read = readProject(old, "a.knitt");
    ASSERT_TRUE(read);
    EXPECT_EQ(read.value().chart.at(0, 1).stitch, Stitch::Tuck);
}

TEST(Project, PictureAndViewAreReadWithoutTheChart) {
    const test::TemporaryFolder folder;
    const auto path = folder / "look.knitt";
    const Project project{.chart = plainChart(3, 2), .machine = {}};
    std::ofstream(path) << writeProject(project, {.thumbnail = "QUJD", .view = "REVG"});
    EXPECT_EQ(readLook(path).thumbnail, "QUJD");
    EXPECT_EQ(readLook(path).view, "REVG");
    std::ofstream(path) << writeProject(project);
    EXPECT_EQ(readLook(path).view, "");
    EXPECT_EQ(readLook("no/such/file.knitt").thumbnail, "");
}

TEST(Project, KeepsEveryStitchAndEveryColourMethod) {
    Project project{.chart = Chart(kStitches, kColourMethods), .machine = {}};
    project.chart.beds = BedUse::Double;
    project.chart.yarns = {{"1", {1, 2, 3}, ""}};
    for (int c = 0; c < kColourMethods; ++c) {
        project.chart.course(c).colours = static_cast<ColourMethod>(c);
        for (int w = 0; w < kStitches; ++w) {
            project.chart.at(w, c).stitch = static_cast<Stitch>(w);
        }
    }
    const auto read = readProject(writeProject(project), "a.knitt");
    ASSERT_TRUE(read);
    EXPECT_EQ(read.value(), project);
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
    const auto read = readProject(writeProject(project, {.thumbnail = "QUJD", .view = "REVG"}), "a.knitt");
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
