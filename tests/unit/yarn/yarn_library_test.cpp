#include "core/base/file.h"
#include "core/yarn/yarn_library.h"
#include "tests/support/temporary_folder.h"

#include <gmock/gmock.h>

namespace knittsim::yarn {
namespace {

using ::testing::IsEmpty;
using ::testing::SizeIs;

class LibraryFolder : public ::testing::Test {
protected:
    void write(const std::string& name, const std::string& text) {
        ASSERT_TRUE(writeFileAtomically(folder / name, text));
    }

    static Yarn yarnCalled(const std::string& id) {
        Yarn yarn = defaultYarn();
        yarn.id = id;
        return yarn;
    }

    const test::TemporaryFolder m_temporary;
    const std::filesystem::path folder = m_temporary.path();
};

TEST_F(LibraryFolder, IsSortedByIdWhateverTheFileNames) {
    write("1.json", toJson(yarnCalled("zephyr")));
    write("2.json", toJson(yarnCalled("alpaca")));
    write("notes.txt", "not a yarn");
    const Result<YarnLibrary> library = YarnLibrary::read(folder);
    ASSERT_TRUE(library);
    EXPECT_THAT(library.diagnostics(), IsEmpty());
    ASSERT_THAT(library.value().yarns(), SizeIs(2));
    EXPECT_EQ(library.value().yarns()[0].id, "alpaca");
    EXPECT_EQ(library.value().find("zephyr"), &library.value().yarns()[1]);
    EXPECT_EQ(library.value().find("merino"), nullptr);
}

TEST_F(LibraryFolder, BadFileIsLeftOutWithAWarning) {
    write("good.json", toJson(yarnCalled("good")));
    write("bad.json", "{");
    const Result<YarnLibrary> library = YarnLibrary::read(folder);
    ASSERT_TRUE(library);
    EXPECT_THAT(library.value().yarns(), SizeIs(1));
    ASSERT_THAT(library.diagnostics(), SizeIs(1));
    EXPECT_EQ(library.diagnostics()[0].severity, Severity::Warning);
    EXPECT_EQ(library.diagnostics()[0].place.file, (folder / "bad.json").string());
}

TEST_F(LibraryFolder, SecondYarnOfOneIdIsLeftOut) {
    write("a.json", toJson(yarnCalled("same")));
    write("b.json", toJson(yarnCalled("same")));
    const Result<YarnLibrary> library = YarnLibrary::read(folder);
    ASSERT_TRUE(library);
    EXPECT_THAT(library.value().yarns(), SizeIs(1));
    ASSERT_THAT(library.diagnostics(), SizeIs(1));
    EXPECT_EQ(library.diagnostics()[0].place.file, (folder / "b.json").string());
}

TEST_F(LibraryFolder, NoYarnAtAllIsAnError) {
    const Result<YarnLibrary> empty = YarnLibrary::read(folder);
    ASSERT_FALSE(empty);
    EXPECT_EQ(empty.diagnostics().back().id, "KS0001");
    EXPECT_FALSE(YarnLibrary::read(folder / "missing"));
}

} // namespace
} // namespace knittsim::yarn
