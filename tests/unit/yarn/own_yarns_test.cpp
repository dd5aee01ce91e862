#include "core/base/file.h"
#include "core/yarn/own_yarns.h"
#include "core/yarn/yarn_library.h"

#include <gtest/gtest.h>

#include <unistd.h>

namespace knittsim::yarn {
namespace {

class OwnYarns : public testing::Test {
protected:
    void SetUp() override { std::filesystem::remove_all(m_folder); }
    void TearDown() override { std::filesystem::remove_all(m_folder); }
    const std::filesystem::path m_folder =
        std::filesystem::temp_directory_path() / ("knittsim_own_yarns_" + std::to_string(::getpid()));
};

TEST_F(OwnYarns, AreKeptReadAndForgotten) {
    Yarn yarn = defaultYarn();
    yarn.id = idOf("My W\xc3\xb6ol, 2/30!");
    EXPECT_EQ(yarn.id, "my-w-ol-2-30");
    EXPECT_FALSE(isOwn(m_folder, yarn.id));
    EXPECT_FALSE(hasErrors(keepYarn(m_folder, yarn)));
    const auto library = YarnLibrary::read(m_folder);
    ASSERT_TRUE(library);
    ASSERT_NE(library.value().find(yarn.id), nullptr);
    EXPECT_EQ(*library.value().find(yarn.id), yarn);
    forgetYarn(m_folder, yarn.id);
    EXPECT_FALSE(isOwn(m_folder, yarn.id));
}

TEST_F(OwnYarns, NoIdLeavesTheFolder) {
    EXPECT_EQ(idOf("../../etc/passwd"), "etc-passwd");
    EXPECT_EQ(idOf("..."), "yarn");
}

TEST_F(OwnYarns, ABadFileIsNotImported) {
    std::filesystem::create_directories(m_folder);
    ASSERT_TRUE(writeFileAtomically(m_folder / "in.txt", "{\"id\": \"x\"}"));
    const auto read = importYarn(m_folder / "in.txt", m_folder / "own");
    ASSERT_FALSE(read);
    EXPECT_EQ(read.diagnostics().front().id, "KS0005");
    EXPECT_FALSE(std::filesystem::exists(m_folder / "own"));
    Yarn yarn = defaultYarn();
    yarn.id = "Some Id";
    ASSERT_TRUE(writeFileAtomically(m_folder / "in.txt", toJson(yarn)));
    ASSERT_TRUE(importYarn(m_folder / "in.txt", m_folder / "own"));
    EXPECT_TRUE(isOwn(m_folder / "own", "some-id"));
}

} // namespace
} // namespace knittsim::yarn
