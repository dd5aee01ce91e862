#include "core/formats/formats.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace knittsim::formats {
namespace {

namespace fs = std::filesystem;

/// A folder of its own for each test, removed with it.
class ReadProgram : public testing::Test {
protected:
    void SetUp() override {
        std::string pattern = (fs::temp_directory_path() / "knittsim-formats-XXXXXX").string();
        ASSERT_NE(mkdtemp(pattern.data()), nullptr);
        m_folder = pattern;
    }
    void TearDown() override { fs::remove_all(m_folder); }

    Result<machine::Program> readBytes(const std::string& name, const std::string& bytes) {
        std::ofstream(m_folder / name, std::ios::binary) << bytes;
        return readProgram(m_folder / name);
    }

    std::string foreignName(const std::string& name, const std::string& bytes) {
        const auto result = readBytes(name, bytes);
        const Diagnostic& first = result.diagnostics().at(0);
        return first.id == "KS0006" ? first.arguments.at(0) : first.id;
    }

    fs::path m_folder;
};

const std::string kKnitout = ";!knitout-2\n;;Carriers: 1\npause\n";

TEST_F(ReadProgram, TellsKnitoutByNameOrByFirstBytes) {
    EXPECT_TRUE(readBytes("a.k", kKnitout));
    EXPECT_TRUE(readBytes("a.KNITOUT", kKnitout));
    EXPECT_TRUE(readBytes("a.txt", kKnitout));
    EXPECT_TRUE(readBytes("noname", kKnitout));
    EXPECT_TRUE(readBytes("nomagic.k", ";;Carriers: 1\npause\n"));
}

TEST_F(ReadProgram, KeepsThePathInTheProgram) {
    EXPECT_EQ(readBytes("a.k", kKnitout).value().file, (m_folder / "a.k").string());
}

TEST_F(ReadProgram, NamesFormatsThatItCannotRead) {
    EXPECT_EQ(foreignName("a.sin", "START\n"), "Stoll Sintral");
    EXPECT_EQ(foreignName("a.JAC", "1002 .A\n"), "Stoll Jacquard");
    EXPECT_EQ(foreignName("a.setx", "x"), "Stoll Setup");
    EXPECT_EQ(foreignName("a.k", "\x89PNG\r\n"), "PNG picture");
    EXPECT_EQ(foreignName("a.txt", "HOME\nRACK:0\n"), "Kniterate k-code");
    EXPECT_EQ(foreignName("a.xyz", "?"), ".xyz");
    EXPECT_EQ(foreignName("a", ""), "no extension, no known first bytes");
}

TEST_F(ReadProgram, TellsShimaDatByItsNumbers) {
    std::string bytes(0x700, '\0');
    bytes.replace(8, 2, "\xE8\x03");
    bytes.replace(16, 2, "\xE8\x03");
    EXPECT_EQ(foreignName("renamed.k", bytes), "Shima DAT");
}

TEST_F(ReadProgram, TellsMissingFilesAndFolders) {
    EXPECT_EQ(readProgram(m_folder / "none.k").diagnostics().at(0).id, "KS0001");
    EXPECT_EQ(readProgram(m_folder).diagnostics().at(0).id, "KS0001");
}

} // namespace
} // namespace knittsim::formats
