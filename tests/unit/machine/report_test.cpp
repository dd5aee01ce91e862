#include "core/machine/checks/report.h"
#include "tests/support/build.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace knittsim::machine {
namespace {

using nlohmann::json;

CheckedFile sample() {
    const Timeline timeline = test::timeline("in 1\ntuck + f0 1\nknit + f1 2\n");
    CheckedFile file{"folder/my piece.k", "generic-e15", {}};
    file.result = applyWaivers(check(timeline), {{"KS0210", "goes on \"tomorrow\""}});
    return file;
}

TEST(JsonReport, CountsAndKeepsWhatIsTurnedOff) {
    const std::vector<CheckedFile> files{sample()};
    const json report = json::parse(toJson(files));
    const json& file = report.at("files").at(0);
    EXPECT_EQ(file.at("file"), "folder/my piece.k");
    EXPECT_EQ(file.at("profile"), "generic-e15");
    EXPECT_EQ(file.at("errors"), 1);
    int off = 0;
    for (const json& finding : file.at("findings")) {
        EXPECT_FALSE(finding.at("cause").get<std::string>().empty());
        if (finding.at("rule") == "KS0201") {
            EXPECT_EQ(finding.at("line"), 5);
            EXPECT_EQ(finding.at("operation"), 2);
            EXPECT_EQ(finding.at("name"), "carrier-not-in");
            EXPECT_EQ(finding.at("needle"), "f1");
            EXPECT_TRUE(finding.at("column").is_null());
        }
        if (finding.contains("off_reason")) {
            EXPECT_EQ(finding.at("off_reason"), "goes on \"tomorrow\"");
            ++off;
        }
    }
    EXPECT_EQ(off, 2);
}

TEST(TextReport, HasALineForEachFindingAndSaysWhatIsTurnedOff) {
    const std::string text = toText(sample());
    EXPECT_NE(text.find("test.k:5: error KS0201: Carrier 2"), std::string::npos) << text;
    EXPECT_NE(text.find("folder/my piece.k: 1 error, 0 warnings"), std::string::npos) << text;
    EXPECT_NE(text.find("2 findings of KS0210 turned off: goes on \"tomorrow\""), std::string::npos) << text;
}

/// SARIF 2.1.0: what a reader needs of sections 3.13 (log), 3.14 (run), 3.27 (result).
TEST(SarifReport, HasTheStructureOfTheStandard) {
    const std::vector<CheckedFile> files{sample(), {"/absolute/other.k", "generic-e15", {}}};
    const json log = json::parse(toSarif(files, "1.2.3"));
    EXPECT_EQ(log.at("version"), "2.1.0");
    ASSERT_EQ(log.at("runs").size(), 1U);
    const json& run = log.at("runs").at(0);
    const json& driver = run.at("tool").at("driver");
    EXPECT_EQ(driver.at("name"), "knittsim-cli");
    EXPECT_EQ(driver.at("version"), "1.2.3");
    EXPECT_EQ(run.at("artifacts").at(0).at("location").at("uri"), "folder/my%20piece.k");
    EXPECT_EQ(run.at("artifacts").at(1).at("location").at("uri"), "file:///absolute/other.k");
    int suppressed = 0;
    for (const json& result : run.at("results")) {
        const json& rule = driver.at("rules").at(result.at("ruleIndex").get<std::size_t>());
        EXPECT_EQ(rule.at("id"), result.at("ruleId"));
        EXPECT_FALSE(result.at("message").at("text").get<std::string>().empty());
        EXPECT_THAT(result.at("level").get<std::string>(), testing::AnyOf("note", "warning", "error"));
        const json& place = result.at("locations").at(0).at("physicalLocation");
        EXPECT_EQ(place.at("artifactLocation").at("uri"), "folder/my%20piece.k");
        EXPECT_GE(place.at("region").at("startLine").get<int>(), 1);
        if (result.contains("suppressions")) {
            EXPECT_EQ(result.at("ruleId"), "KS0210");
            EXPECT_EQ(result.at("suppressions").at(0).at("kind"), "external");
            ++suppressed;
        }
    }
    EXPECT_EQ(suppressed, 2);
}

TEST(SarifReport, AFindingWithoutLineHasNoRegion) {
    CheckedFile file{"a.k", {}, {}};
    file.result.findings = {{"KS0242", Severity::Warning, Place{.file = "a.k"}, {"Jenny", "Generic"}}};
    const json log = json::parse(toSarif(std::vector{file}, "1"));
    const json& place = log.at("runs").at(0).at("results").at(0).at("locations").at(0).at("physicalLocation");
    EXPECT_FALSE(place.contains("region"));
}

TEST(Reports, BytesThatAreNoUtf8DoNotStopThem) {
    CheckedFile file{"caf\xe9.k", {}, {}};
    file.result.findings = {{"KS0109", Severity::Error, Place{.file = "a.k", .line = 3}, {"\xff"}}};
    EXPECT_TRUE(json::accept(toJson(std::vector{file})));
    EXPECT_TRUE(json::accept(toSarif(std::vector{file}, "1")));
}

} // namespace
} // namespace knittsim::machine
