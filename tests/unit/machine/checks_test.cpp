#include "core/base/message_table.h"
#include "core/formats/formats.h"
#include "core/machine/checks/check.h"
#include "core/machine/checks/findings.h"
#include "core/machine/checks/rules.h"
#include "core/machine/profile_library.h"
#include "tests/support/build.h"
#include "tests/support/for_random_programs.h"
#include "tests/support/machine_data.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <set>

namespace knittsim::machine {
namespace {

using test::pass;
using testing::ElementsAre;
using testing::IsEmpty;

Diagnostics findings(const std::string& lines, const std::string& rule,
                     const MachineProfile& profile = genericProfile()) {
    Diagnostics found = check(Timeline(test::program(lines), profile));
    std::erase_if(found, [&](const Diagnostic& d) { return d.id != rule; });
    return found;
}

TEST(Rules, EveryRuleHasItsSentencesAndEveryMachineSentenceItsRule) {
    for (const Rule& rule : rules()) {
        EXPECT_NE(findMessage(rule.id), nullptr) << rule.id;
    }
    for (const Message& message : messages()) {
        if (message.id.starts_with("KS02") && message.id != "KS0244") { // a fault of the command line
            EXPECT_NE(findRule(message.id), nullptr) << message.id;
        }
    }
}

TEST(Rules, NamesDiffer) {
    std::set<std::string_view> names;
    for (const Message& message : messages()) {
        EXPECT_TRUE(names.insert(message.name).second) << message.name;
    }
}

TEST(Checks, ADroppedLoopTellsHowManyStitchesRun) {
    // Three courses above the cast-on: the wale of f1 has four loops.
    const std::string fabric = "in 1\n" + pass("tuck", 'f', 0, 3, 1) + pass("knit", 'f', 3, 0, 1) +
                               pass("knit", 'f', 0, 3, 1) + pass("knit", 'f', 3, 0, 1) + "out 1\n";
    const auto one = findings(fabric + "drop f1\n", "KS0229");
    ASSERT_EQ(one.size(), 1U);
    EXPECT_THAT(one[0].arguments, ElementsAre("f1", "1 loop", "4"));
    const auto row = findings(fabric + "drop f0\ndrop f1\ndrop f2\n", "KS0229");
    ASSERT_EQ(row.size(), 1U) << "drops in a row are one finding";
    EXPECT_THAT(row[0].arguments, ElementsAre("f0", "3 loops", "12"));
    EXPECT_EQ(row[0].place.line, one[0].place.line);
}

TEST(Checks, ALadderEndsWhereAnotherLoopHolds) {
    // The decrease draws one loop through those of f0 and f1: dropping f1 later lets nothing of f0 run.
    const std::string decrease = "in 1\n" + pass("tuck", 'f', 0, 3, 1) + pass("knit", 'f', 3, 0, 1) +
                                 "xfer f1 b1\nrack -1\nxfer b1 f0\nrack 0\n" + pass("knit", 'f', 0, 3, 1) +
                                 "out 1\n";
    EXPECT_THAT(findings(decrease + "drop f1\n", "KS0229").at(0).arguments, ElementsAre("f1", "1 loop", "1"));
    EXPECT_THAT(findings(decrease + "drop f0\n", "KS0229").at(0).arguments, ElementsAre("f0", "1 loop", "5"));
}

TEST(Checks, HeldPassesAreCountedExactly) {
    // f2 rests while the yarn passes it; the stitch itself is no pass.
    const auto program = [](int rests) {
        std::string lines = "in 1\n" + pass("tuck", 'f', 0, 4, 1);
        for (int i = 0; i < rests; ++i) {
            lines += i % 2 == 0 ? pass("knit", 'f', 4, 3, 1) + pass("knit", 'f', 1, 0, 1)
                                : pass("knit", 'f', 0, 1, 1) + pass("knit", 'f', 3, 4, 1);
        }
        return lines + (rests % 2 == 0 ? pass("knit", 'f', 4, 0, 1) : pass("knit", 'f', 0, 4, 1)) + "out 1\n";
    };
    MachineProfile profile = genericProfile();
    profile.limits.heldPasses = 4;
    EXPECT_THAT(findings(program(4), "KS0232", profile), IsEmpty());
    const auto found = findings(program(5), "KS0232", profile);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_THAT(found[0].arguments, ElementsAre("f2", "6", "5", "4"));
}

TEST(Checks, ALoopBesideATurnIsHeldToo) {
    // Short rows over f0 and f1: the loop of f2 is tugged at by every turn.
    std::string lines = "in 1\n" + pass("tuck", 'f', 3, 0, 1);
    for (int i = 0; i < 6; ++i) {
        lines += pass("knit", 'f', 0, 1, 1) + pass("knit", 'f', 1, 0, 1);
    }
    MachineProfile profile = genericProfile();
    profile.limits.heldPasses = 3;
    const auto found = findings(lines + pass("knit", 'f', 0, 3, 1) + "out 1\n", "KS0232", profile);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].place.needle, "f2");
}

TEST(Checks, FloatsAreMeasuredInMillimetresAndNeedles) {
    MachineProfile profile = genericProfile();
    profile.gauge = 25.4; // pitch 1 mm
    profile.limits.floatNeedles = 100;
    profile.limits.floatMm = 9;
    EXPECT_THAT(findings("in 1\ntuck + f0 1\ntuck + f9 1\nout 1\n", "KS0233", profile), IsEmpty());
    const auto found = findings("in 1\ntuck + f0 1\ntuck + f10 1\nout 1\n", "KS0233", profile);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_THAT(found[0].arguments, ElementsAre("1", "10.0", "10", "9", "100"));
    profile.limits.floatNeedles = 5;
    EXPECT_EQ(findings("in 1\ntuck + f0 1\ntuck + f6 1\nout 1\n", "KS0233", profile).size(), 1U);
}

TEST(Checks, StretchComparesTheWayWithTheYarn) {
    // Two loops of 5 mm beside each other, one moved by `rack` pitches of 1 mm: way 1 + rack, yarn 5 mm.
    MachineProfile profile = genericProfile();
    profile.gauge = 25.4;
    profile.stitchTable.clear();
    profile.defaultLoopLengthMm = 5;
    profile.bedGapMm = 0.001;
    profile.limits.stretch = 1;
    const auto moved = [&](int rack) {
        return findings("in 1\ntuck + f0 1\ntuck + f1 1\nxfer f1 b1\nrack " + std::to_string(rack) +
                            "\nxfer b1 f" + std::to_string(1 + rack) + "\nout 1\n",
                        "KS0235", profile);
    };
    EXPECT_THAT(moved(3), IsEmpty());
    const auto found = moved(5);
    ASSERT_EQ(found.size(), 1U) << "said once, at the rack";
    EXPECT_EQ(found[0].place.line, 7);
    EXPECT_THAT(found[0].arguments, ElementsAre("f0", "b1", "6.0", "5.0"));
}

TEST(Checks, NotesOfOperationsInARowAreOne) {
    const auto found = findings(
        "in 1\nknit + f0 1\nknit + f1 1\nknit + f2 1\nrack 1\nrack 0\nknit - f9 1\nout 1\n", "KS0228");
    ASSERT_EQ(found.size(), 2U);
    EXPECT_THAT(found[0].arguments, ElementsAre("f0", "3 in a row"));
    EXPECT_THAT(found[1].arguments, ElementsAre("f9", "once"));
}

TEST(Checks, LoopsFromTheSliderCountAsGivenBack) {
    EXPECT_THAT(findings("in 1\ntuck + f0 1\nxfer f0 bs0\nxfer bs0 f0\nknit - f0 1\nout 1\n", "KS0223"),
                IsEmpty());
}

TEST(Checks, FindingsOfARuleAreBoundedAndTheRestIsCounted) {
    std::string lines = "in 1\n";
    for (int i = 0; i < 700; ++i) {
        lines += "rack 50\nrack 0\n";
    }
    const std::string program = lines + "tuck + f0 1\nout 1\n";
    EXPECT_EQ(findings(program, "KS0218").size(), kMaxFindingsOfRule);
    const auto rest = findings(program, "KS0243");
    ASSERT_EQ(rest.size(), 1U);
    EXPECT_THAT(rest[0].arguments, ElementsAre("200", "KS0218"));
}

TEST(Checks, FindingsComeInTheOrderOfTheProgram) {
    const Diagnostics found = check(test::timeline(
        "inhook 1\nknit + f0 2\nout 3\ntuck + f40 2\nrack 99\nknit + f0 1\nxfer f0 f1\nout 2\n"));
    EXPECT_GE(found.size(), 6U);
    EXPECT_TRUE(std::ranges::is_sorted(found, {}, [](const Diagnostic& d) { return d.place.line; }));
}

TEST(Checks, AnEmptyProgramHasNoFindings) {
    EXPECT_THAT(check(Timeline(Program{}, genericProfile())), IsEmpty());
}

TEST(Waivers, TakeOutARuleAndKeepTheReason) {
    const auto waiver = parseWaiver("carrier-stays-in=the next piece goes on with it");
    ASSERT_TRUE(waiver);
    EXPECT_EQ(waiver.value(), (Waiver{"KS0210", "the next piece goes on with it"}));
    const CheckResult result =
        applyWaivers(check(test::timeline("in 1\ntuck + f0 1\nknit + f1 2\n")), {waiver.value()});
    EXPECT_TRUE(hasErrors(result.findings)) << "carrier 2 was not brought in";
    EXPECT_EQ(std::ranges::count(result.findings, "KS0210", &Diagnostic::id), 0);
    ASSERT_EQ(result.waived.size(), 2U);
    EXPECT_EQ(result.waived[0].reason, "the next piece goes on with it");
}

TEST(Waivers, NeedAKnownRuleAndAReason) {
    EXPECT_EQ(parseWaiver("KS9999=because").diagnostics().at(0).id, "KS0008");
    EXPECT_EQ(parseWaiver("KS0210").diagnostics().at(0).id, "KS0244");
    EXPECT_EQ(parseWaiver("KS0210=").diagnostics().at(0).id, "KS0244");
    MachineProfile profile = genericProfile();
    profile.checksOff = {{"long-float", "shown on purpose"}};
    EXPECT_THAT(waiversOf(profile).value(), ElementsAre(Waiver{"KS0233", "shown on purpose"}));
    profile.checksOff = {{"no-such-rule", "typing error"}};
    EXPECT_FALSE(waiversOf(profile));
}

/// Error ids of a file with the line of the first, for messages.
std::string errorsOf(const std::filesystem::path& file) {
    Diagnostics problems;
    const auto library =
        ProfileLibrary::read({std::filesystem::path(KNITTSIM_SOURCE_DIR) / "resources/machines"}, problems);
    auto program = formats::readProgram(file);
    if (!program) {
        return "cannot be read";
    }
    auto profile = chooseProfile(program.value(), library);
    std::string errors;
    for (const Diagnostic& found : check(Timeline(std::move(program).value(), std::move(profile).value()))) {
        errors += found.severity == Severity::Error ? toLine(found) + '\n' : "";
    }
    return errors;
}

TEST(Checks, ValidRandomProgramsHaveNoErrors) {
    test::forRandomPrograms(60, {.operations = 800}, [](const Program& program) {
        for (const Diagnostic& found : check(Timeline(program, genericProfile()))) {
            // Their transfers move single loops any way, so some yarns are pulled too far.
            if (found.severity == Severity::Error && found.id != "KS0235") {
                return toLine(found);
            }
        }
        return std::string();
    });
}

TEST(Checks, OurSamplesHaveNoErrors) {
    int count = 0;
    for (const auto& entry : std::filesystem::directory_iterator(std::filesystem::path(KNITTSIM_SOURCE_DIR) /
                                                                 "resources/patterns")) {
        if (entry.path().extension() == ".k") {
            EXPECT_EQ(errorsOf(entry.path()), "") << entry.path();
            ++count;
        }
    }
    EXPECT_GT(count, 10);
}

TEST(Checks, ProgramsKnittedOnRealMachinesHaveNoErrors) {
    if (!std::filesystem::is_directory(test::machineData())) {
        GTEST_SKIP() << "no machine data in " << test::machineData();
    }
    for (const auto& entry : std::filesystem::recursive_directory_iterator(test::machineData())) {
        const std::string ending = entry.path().extension().string();
        if (ending == ".k" || ending == ".knitout" || ending == ".kc" || ending == ".dat") {
            EXPECT_EQ(errorsOf(entry.path()), "") << entry.path();
        }
    }
}

} // namespace
} // namespace knittsim::machine
