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
    EXPECT_EQ(with("\"knitt\": 1", "\"knitt\": 2"), "KS0509");
    EXPECT_EQ(with("\"kkk\"", "\"kk\""), "KS0004");
    EXPECT_EQ(with("\"kkk\"", "\"kxk\""), "KS0004");
    EXPECT_EQ(with("\"yarns\": \"0\"", "\"yarns\": \"4\""), "fine"); // it can be mended
    EXPECT_EQ(with("\"yarns\": \"0\"", "\"yarns\": \"0\", \"moves\": [[0, 99999999999]]"), "KS0503");
    EXPECT_EQ(with("\"yarns\": \"0\"", "\"yarns\": \"0\", \"moves\": [[0.5, 1]]"), "KS0004");
    EXPECT_EQ(with("\"wales\": 3", "\"wales\": 3000000"), "KS0004");
    EXPECT_EQ(idOf(good.substr(0, good.size() / 2)), "KS0003");
    EXPECT_EQ(idOf("[1]"), "KS0004");
}

} // namespace
} // namespace knittsim::pattern
