#include "core/export/report.h"
#include "core/fabric/fabric_builder.h"
#include "tests/support/build.h"
#include "tests/support/temporary_folder.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <fstream>

namespace knittsim::exports {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

/// Four needles to the right; the loop of f1 goes to b1 and the beds move; then f4 to f2 to the left and,
/// after a float over f3 and f2, f1. Carrier 2 only misses.
const char* const kProgram = "in 1\nknit + f1 1\nknit + f2 1\nknit + f3 1\nknit + f4 1\n"
                             "xfer f1 b1\nrack 2\nrack -3\nrack 0\nxfer b1 f1\n"
                             "knit - f4 1\nknit - f1 1\nout 1\n";

machine::CarrierYarn yarn(const char* carrier, const char* name, double tex) {
    machine::CarrierYarn made{.carrier = carrier, .used = true, .yarn = yarn::defaultYarn()};
    made.yarn.name = name;
    made.yarn.tex = tex;
    return made;
}

Report makeReport(const machine::Timeline& timeline) {
    const fabric::Fabric fabric = fabric::buildFabric(timeline);
    return {.file = "folder/<script>alert('1')</script>&\".k",
            .sha256 = "0123",
            .knitting = describe(timeline, fabric, {yarn("1", "Fine <b>", 50), yarn("2", "None", 50)}),
            .checks =
                machine::applyWaivers(machine::check(timeline), {{"KS0230", "goes on <i>tomorrow</i>"}}),
            .version = "1.2"};
}

TEST(Report, CountsWhatTheProgramSays) {
    const machine::Timeline timeline = test::timeline(kProgram);
    const Knitting found = *makeReport(timeline).knitting;
    EXPECT_EQ(found.profileId, "generic-e15");
    EXPECT_EQ(found.totals.operations, 13u);
    EXPECT_EQ(found.totals.passes, 2u);
    EXPECT_EQ(found.totals.needles, 4u);
    EXPECT_EQ(found.totals.frontNeedles, 4u);
    EXPECT_EQ(found.totals.rearNeedles, 0u);
    EXPECT_EQ(found.totals.loops, 6u);
    EXPECT_EQ(found.totals.courses, 2);
    ASSERT_TRUE(found.longestFloat.has_value());
    EXPECT_EQ(found.longestFloat->needles, 3) << "from f4 to f1";
    EXPECT_DOUBLE_EQ(found.longestFloat->mm, 3 * 25.4 / 15);
    EXPECT_EQ(found.longestFloat->place.needle, "f1");
    EXPECT_EQ(found.longestFloat->place.operation, 11);
    ASSERT_TRUE(found.largestRacking.has_value());
    EXPECT_EQ(found.largestRacking->pitches, -3);
    EXPECT_EQ(found.largestRacking->place.operation, 7);
}

TEST(Report, YarnIsWhatTheFabricHoldsAndItsMassFollowsFromTex) {
    const machine::Timeline timeline = test::timeline(kProgram);
    const fabric::Fabric fabric = fabric::buildFabric(timeline);
    double mm = 0;
    for (const fabric::Yarn& yarn : fabric.yarns) {
        mm += yarn.lengthMm;
    }
    const std::vector<YarnUse> yarns = makeReport(timeline).knitting->yarns;
    ASSERT_EQ(yarns.size(), 1u) << "carrier 2 feeds nothing";
    EXPECT_EQ(yarns[0].carrier, "1");
    EXPECT_GT(mm, 6 * 4.0) << "six loops of 4 mm or more";
    EXPECT_NEAR(yarns[0].metres, mm / 1000, 1e-12);
    EXPECT_NEAR(yarns[0].grams(), mm / 1000 * 50 / 1000, 1e-12) << "50 g/km";
}

TEST(Report, TheTimeCountsStrokesByHand) {
    const machine::Timeline timeline = test::timeline(kProgram);
    const KnittingTime time = estimateTime(timeline.program(), timeline.profile());
    const double pitch = 25.4 / 15 / 1000; // m
    const double beyond = 5;               // pitches: 2.5 at either end
    EXPECT_EQ(time.knitStrokes, 2);
    EXPECT_EQ(time.transferStrokes, 2);
    // Right, a transfer to the left, one to the right, then to the left: the carriage is always there.
    EXPECT_EQ(time.emptyStrokes, 0);
    EXPECT_NEAR(time.knitMetres, 2 * (3 + beyond) * pitch, 1e-12);
    EXPECT_NEAR(time.transferMetres, 2 * beyond * pitch, 1e-12);
    EXPECT_TRUE(time.speed.assumed);
    EXPECT_NEAR(time.seconds(), time.knitMetres / 0.8 + time.transferMetres / 0.5 + 4 * 0.6, 1e-12);
}

TEST(Report, ACarriageOnTheWrongSideComesOverEmpty) {
    const machine::Timeline timeline =
        test::timeline("in 1\nknit + f1 1\nknit + f2 1\nxfer f1 b1\nknit - f2 1\nknit + f2 1\nmiss + f3 1\n"
                       "out 1\n");
    const KnittingTime time = estimateTime(timeline.program(), timeline.profile());
    EXPECT_EQ(time.knitStrokes, 3);
    EXPECT_EQ(time.transferStrokes, 1);
    EXPECT_EQ(time.emptyStrokes, 1) << "the transfer left it on the left, the pass starts on the right";
}

TEST(Report, TheProfilesOwnSpeedIsNotAssumed) {
    machine::MachineProfile profile = machine::genericProfile();
    profile.speed = {
        .knitMetresPerSecond = 2, .transferMetresPerSecond = 1, .turnSeconds = 0, .assumed = false};
    const machine::Timeline generic = test::timeline(kProgram);
    const machine::Timeline timeline(generic.program(), profile);
    const Report report = makeReport(timeline);
    EXPECT_NEAR(report.knitting->time.seconds(),
                report.knitting->time.knitMetres / 2 + report.knitting->time.transferMetres, 1e-12);
    EXPECT_THAT(toHtml(report), Not(HasSubstr("assumed")));
    EXPECT_THAT(toHtml(makeReport(generic)), HasSubstr("speeds assumed"));
}

TEST(HtmlReport, EscapesAllTextAndIsOnePage) {
    const std::string html = toHtml(makeReport(test::timeline(kProgram)));
    EXPECT_THAT(html, Not(HasSubstr("<script")));
    EXPECT_THAT(html, HasSubstr("folder/&lt;script&gt;alert(&#39;1&#39;)&lt;/script&gt;&amp;&quot;.k"));
    EXPECT_THAT(html, HasSubstr("Fine &lt;b&gt;"));
    EXPECT_THAT(html, HasSubstr("Turned off: goes on &lt;i&gt;tomorrow&lt;/i&gt;"));
    for (const char* elsewhere : {"http:", "https:", "src=", "href=", "url(", "@import"}) {
        EXPECT_THAT(html, Not(HasSubstr(elsewhere)));
    }
    EXPECT_THAT(html, HasSubstr("KS0230"));
    EXPECT_THAT(html, HasSubstr("prefers-color-scheme: dark"));
    EXPECT_THAT(html, HasSubstr("@media print"));
}

TEST(HtmlReport, BytesThatAreNoTextDoNoHarm) {
    Report report = makeReport(test::timeline(kProgram));
    report.file = "M\xFCtze.k";
    EXPECT_THAT(toHtml(report), HasSubstr("M?tze.k"));
    EXPECT_NO_THROW(json::parse(toJson(report)));
}

TEST(JsonReport, NamesValuesWithTheirUnits) {
    const Report report = makeReport(test::timeline(kProgram));
    const json found = json::parse(toJson(report));
    EXPECT_EQ(found.at("file"), report.file);
    EXPECT_EQ(found.at("sha256"), "0123");
    EXPECT_EQ(found.at("machine").at("id"), "generic-e15");
    EXPECT_EQ(found.at("sizes").at("passes"), 2);
    EXPECT_NEAR(found.at("yarn").at(0).at("mass_g").get<double>(), report.knitting->yarns[0].grams(), 5e-4);
    EXPECT_EQ(found.at("longest_float").at("needles"), 3);
    EXPECT_EQ(found.at("longest_float").at("course"), 2);
    EXPECT_EQ(found.at("largest_racking").at("pitches"), -3);
    EXPECT_EQ(found.at("knitting_time").at("assumed"), true);
    EXPECT_EQ(found.at("findings").size(), report.checks.findings.size() + report.checks.waived.size());
    EXPECT_EQ(found.at("findings").back().at("off_reason"), "goes on <i>tomorrow</i>");
}

TEST(JsonReport, AFileThatCannotBeReadHasFindingsOnly) {
    Report report;
    report.file = "a.k";
    report.checks.findings.push_back({"KS0012", Severity::Error, Place{.file = "a.k"}, {}});
    const json found = json::parse(toJson(report));
    EXPECT_EQ(found.at("readable"), false);
    EXPECT_TRUE(found.at("sha256").is_null());
    EXPECT_FALSE(found.contains("sizes"));
    EXPECT_EQ(found.at("findings").at(0).at("cause"), "The file is empty.");
    EXPECT_THAT(toHtml(report), HasSubstr("The file is empty."));
}

TEST(WriteReport, TheExtensionChoosesTheFormat) {
    const Report report = makeReport(test::timeline(kProgram));
    const test::TemporaryFolder folder;
    const auto text = [](const std::filesystem::path& path) { return readFile(path).value(); };
    ASSERT_TRUE(writeReport(report, folder / "report.HTML"));
    EXPECT_EQ(text(folder / "report.HTML"), toHtml(report));
    ASSERT_TRUE(writeReport(report, folder / "report.json"));
    EXPECT_EQ(text(folder / "report.json"), toJson(report));
    EXPECT_EQ(writeReport(report, folder / "report.pdf").diagnostics().at(0).id, "KS0025");
    EXPECT_EQ(writeReport(report, folder / "none" / "a.html").diagnostics().at(0).id, "KS0002");
}

} // namespace
} // namespace knittsim::exports
