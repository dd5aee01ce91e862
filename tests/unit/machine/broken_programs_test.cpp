// Programs with one fault each. The lines of a program say themselves what is wrong with them: a comment
// "-> KS0201" names the findings of its line, "file -> KS0242" those of the file.

#include "core/base/message_table.h"
#include "core/formats/formats.h"
#include "core/machine/checks/check.h"
#include "core/machine/checks/findings.h"
#include "core/machine/checks/rules.h"
#include "core/machine/profile_library.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <fstream>
#include <set>
#include <sstream>

namespace knittsim::machine {
namespace {

const std::filesystem::path kPrograms =
    std::filesystem::path(KNITTSIM_SOURCE_DIR) / "tests/unit/machine/programs";

std::vector<std::filesystem::path> programsIn(const char* folder) {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(kPrograms / folder)) {
        files.push_back(entry.path());
    }
    std::ranges::sort(files);
    return files;
}

using Expected = std::multiset<std::pair<int, std::string>>; // line, rule

Expected readExpected(const std::filesystem::path& file) {
    Expected expected;
    std::ifstream in(file);
    std::string line;
    for (int number = 1; std::getline(in, line); ++number) {
        const std::size_t arrow = line.find("-> ");
        if (arrow == std::string::npos) {
            continue;
        }
        const bool wholeFile = line.find("file -> ") != std::string::npos;
        std::istringstream words(line.substr(arrow + 3));
        for (std::string rule; words >> rule;) {
            expected.emplace(wholeFile ? -1 : number, rule);
        }
    }
    return expected;
}

/// What reader, choice of profile and checks find.
Diagnostics findAll(const std::filesystem::path& file) {
    Diagnostics all;
    const auto take = [&](const Diagnostics& more) { all.insert(all.end(), more.begin(), more.end()); };
    auto program = formats::readProgram(file);
    take(program.diagnostics());
    if (program) {
        auto profile = chooseProfile(
            program.value(),
            ProfileLibrary::read({std::filesystem::path(KNITTSIM_SOURCE_DIR) / "resources/machines"}, all));
        take(profile.diagnostics());
        take(check(Timeline(std::move(program).value(), std::move(profile).value())));
    }
    return all;
}

std::string nameOf(const testing::TestParamInfo<std::filesystem::path>& info) {
    std::string name = info.param.stem().string();
    std::ranges::replace(name, '-', '_');
    return name;
}

class BrokenProgram : public testing::TestWithParam<std::filesystem::path> {};

/// Notes that a program does not speak of do not matter; every warning and every error does.
TEST_P(BrokenProgram, IsFoundAtItsLineAndNothingElseIs) {
    const Expected expected = readExpected(GetParam());
    ASSERT_FALSE(expected.empty());
    Expected found;
    for (const Diagnostic& finding : findAll(GetParam())) {
        const std::pair<int, std::string> place{finding.place.line, finding.id};
        const Rule* rule = findRule(finding.id);
        EXPECT_TRUE(rule == nullptr || rule->severity == finding.severity) << finding.id;
        EXPECT_EQ((causeText(finding) + cureText(finding)).find('{'), std::string::npos)
            << finding.id << " lacks an argument";
        if (finding.severity != Severity::Info || expected.contains(place)) {
            found.insert(place);
        }
    }
    EXPECT_EQ(found, expected);
}

INSTANTIATE_TEST_SUITE_P(All, BrokenProgram, testing::ValuesIn(programsIn("broken")), nameOf);

class SoundProgram : public testing::TestWithParam<std::filesystem::path> {};

TEST_P(SoundProgram, RaisesNoWarning) {
    for (const Diagnostic& finding : findAll(GetParam())) {
        EXPECT_EQ(finding.severity, Severity::Info) << finding.id << " in line " << finding.place.line;
    }
}

INSTANTIATE_TEST_SUITE_P(All, SoundProgram, testing::ValuesIn(programsIn("sound")), nameOf);

TEST(BrokenPrograms, ThereIsOneForEveryRule) {
    std::set<std::string> broken;
    for (const auto& file : programsIn("broken")) {
        for (const auto& [line, rule] : readExpected(file)) {
            broken.insert(rule);
        }
    }
    for (const Rule& rule : rules()) {
        const bool counts = rule.id == "KS0211" || rule.id == "KS0243"; // say how many more there are
        EXPECT_TRUE(counts || broken.contains(std::string(rule.id))) << rule.id;
    }
}

} // namespace
} // namespace knittsim::machine
