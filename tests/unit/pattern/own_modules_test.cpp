#include "core/base/file.h"
#include "core/pattern/own_modules.h"
#include "knitted.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <fstream>

namespace knittsim::pattern {
namespace {

class OwnModules : public ::testing::Test {
protected:
    std::vector<std::string> names() const {
        Diagnostics problems;
        std::vector<std::string> all;
        for (const Module& module : readOwnModules(m_folder, problems)) {
            all.push_back(module.name);
        }
        return all;
    }

    test::TemporaryFolder m_temporary;
    const std::filesystem::path m_folder = m_temporary.path();
};

TEST_F(OwnModules, AreReadAsTheyWereSaved) {
    Chart part = chartOf({"kkpp", "kkkk"});
    part.course(1).moves = cross(0, 1, 1, Front::Left);
    EXPECT_TRUE(names().empty()); // no folder yet
    EXPECT_TRUE(saveOwnModule(m_folder, "My cable, left", part).empty());
    Diagnostics problems;
    const auto modules = readOwnModules(m_folder, problems);
    ASSERT_EQ(modules.size(), 1U);
    EXPECT_EQ(modules[0].name, "My cable, left");
    EXPECT_EQ(modules[0].part, part);
    EXPECT_TRUE(problems.empty());
}

TEST_F(OwnModules, CanBeRenamedAndRemoved) {
    const Chart part = chartOf({"kp"});
    EXPECT_TRUE(saveOwnModule(m_folder, "b", part).empty());
    EXPECT_TRUE(saveOwnModule(m_folder, "c", part).empty());
    EXPECT_TRUE(renameOwnModule(m_folder, "c", "a").empty());
    EXPECT_EQ(names(), (std::vector<std::string>{"a", "b"}));
    EXPECT_EQ(renameOwnModule(m_folder, "a", "b")[0].id, "KS0516"); // taken
    EXPECT_TRUE(removeOwnModule(m_folder, "b").empty());
    EXPECT_EQ(names(), std::vector<std::string>{"a"});
}

TEST_F(OwnModules, BadNamesAndTakenOnesAreRefused) {
    const Chart part = chartOf({"kp"});
    for (const char* name : {"", ".", "..", "../x", "a/b", " a", "a ", "a\nb", "a:b"}) {
        const Diagnostics problems = saveOwnModule(m_folder, name, part);
        ASSERT_EQ(problems.size(), 1U) << name;
        EXPECT_EQ(problems[0].id, "KS0516");
    }
    EXPECT_TRUE(saveOwnModule(m_folder, "a", part).empty());
    EXPECT_EQ(saveOwnModule(m_folder, "a", part)[0].id, "KS0516");
}

TEST_F(OwnModules, ABadFileIsLeftOutWithTheReason) {
    EXPECT_TRUE(saveOwnModule(m_folder, "good", chartOf({"kp"})).empty());
    std::ofstream(m_folder / "bad.knitt") << "{\"knitt\": 1, ";
    Diagnostics problems;
    EXPECT_EQ(readOwnModules(m_folder, problems).size(), 1U);
    ASSERT_FALSE(problems.empty());
    EXPECT_EQ(problems[0].id, "KS0003");
    EXPECT_EQ(problems[0].severity, Severity::Warning);
    EXPECT_NE(problems[0].place.file.find("bad.knitt"), std::string::npos);
}

} // namespace
} // namespace knittsim::pattern
