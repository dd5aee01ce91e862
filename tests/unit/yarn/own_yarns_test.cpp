#include "core/base/file.h"
#include "core/yarn/own_yarns.h"
#include "core/yarn/yarn_library.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

namespace knittsim::yarn {
namespace {

class OwnYarns : public testing::Test {
protected:
    test::TemporaryFolder m_temporary;
    const std::filesystem::path m_folder = m_temporary.path();
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
    ASSERT_TRUE(writeFileAtomically(m_folder / "in.txt", "{\"id\": \"x\"}"));
    const auto read = importYarns(m_folder / "in.txt", m_folder / "own");
    ASSERT_FALSE(read);
    EXPECT_EQ(read.diagnostics().front().id, "KS0005");
    EXPECT_FALSE(std::filesystem::exists(m_folder / "own"));
    Yarn yarn = defaultYarn();
    yarn.id = "Some Id";
    ASSERT_TRUE(writeFileAtomically(m_folder / "in.txt", toJson(yarn)));
    ASSERT_TRUE(importYarns(m_folder / "in.txt", m_folder / "own"));
    EXPECT_TRUE(isOwn(m_folder / "own", "some-id"));
}

TEST_F(OwnYarns, ALibraryInOneFileComesBackWhole) {
    Yarn wool = defaultYarn();
    wool.id = "wool";
    wool.sources = {{"friction", "measured on a tensiometer"}};
    Yarn linen = defaultYarn();
    linen.id = "linen";
    linen.tex = 26;
    linen.count = "26 tex";
    const std::string text = toJson({wool, linen});
    EXPECT_LT(text.find("\"linen\""), text.find("\"wool\"")) << "in the order of the ids";
    EXPECT_EQ(text, toJson({linen, wool}));
    ASSERT_TRUE(writeFileAtomically(m_folder / "all.json", text));
    const auto read = importYarns(m_folder / "all.json", m_folder / "own");
    ASSERT_TRUE(read);
    EXPECT_EQ(read.value(), (std::vector<Yarn>{linen, wool}));
    const auto again = importYarns(m_folder / "all.json", m_folder / "own");
    ASSERT_TRUE(again);
    EXPECT_EQ(again.value().front().id, "linen-2") << "none is replaced";
    EXPECT_TRUE(isOwn(m_folder / "own", "linen"));
}

TEST_F(OwnYarns, OneBadYarnOfALibraryIsNamedAndNoneIsTaken) {
    Yarn good = defaultYarn();
    std::string text = toJson({good, good});
    const std::string key = "\"friction\": ";
    const std::size_t last = text.rfind(key) + key.size();
    text.replace(last, text.find(',', last) - last, "7");
    const auto read = parseYarns(text, "all.json");
    ASSERT_FALSE(read);
    EXPECT_EQ(read.diagnostics().size(), 1U);
    EXPECT_EQ(read.diagnostics().front().arguments.front(), "yarns[1].friction");
    EXPECT_FALSE(parseYarns("{\"yarns\": []}", "all.json"));
}

} // namespace
} // namespace knittsim::yarn
