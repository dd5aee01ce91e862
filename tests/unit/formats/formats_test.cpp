#include "core/base/message_table.h"
#include "core/formats/formats.h"
#include "core/formats/knitout/reader.h"
#include "core/formats/shima_dat/raster.h"
#include "tests/support/temporary_folder.h"

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
    Result<machine::Program> readBytes(const std::string& name, const std::string& bytes) {
        std::ofstream(m_folder / name, std::ios::binary) << bytes;
        return readProgram(m_folder / name);
    }

    std::string foreignName(const std::string& name, const std::string& bytes) {
        const auto result = readBytes(name, bytes);
        const Diagnostic& first = result.diagnostics().at(0);
        return first.id == "KS0006" ? first.arguments.at(0) : first.id;
    }

    test::TemporaryFolder m_temporary;
    const std::filesystem::path m_folder = m_temporary.path();
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
    EXPECT_EQ(foreignName("a.JAC", "1002 .A\n"), "Stoll Jacquard without its .sin file");
    EXPECT_EQ(foreignName("a.setx", "x"), "Stoll Setup");
    EXPECT_EQ(foreignName("a.k", "\x89PNG\r\n"), "PNG picture");
    EXPECT_EQ(foreignName("a.xyz", "?"), ".xyz");
    EXPECT_EQ(foreignName("a", ""), "no extension, no known first bytes");
}

const std::string kSintral = "START\nSEN=1-2 JA1=1002\n<< S:A-0; Y:1; S1\nEND\n";
const std::string kKcode = "HOME\nRACK:0\n// a.kc\n";

TEST_F(ReadProgram, TellsTheOtherFormatsByNameOrByFirstBytes) {
    std::string dat(0x700, '\0');
    dat.replace(8, 2, "\xE8\x03");
    dat.replace(16, 2, "\xE8\x03");
    EXPECT_EQ(foreignName("renamed.k", dat), "KS0131"); // found to be a picture, with runs of nothing
    EXPECT_EQ(foreignName("a.DAT", "no picture"), "KS0130");
    EXPECT_EQ(foreignName("a.txt", kKcode), "KS0140");
    EXPECT_EQ(foreignName("a.kc", "// nothing\n"), "KS0140");
    EXPECT_EQ(foreignName("a.txt", kSintral), "KS0155");
    EXPECT_EQ(foreignName("a.SIN", "C nothing\n"), "KS0121");
    EXPECT_TRUE(readBytes("a.dat", kKnitout));
}

TEST_F(ReadProgram, ReadsTheJacquardBesideItsSintral) {
    std::ofstream(m_folder / "a.JAC") << "1002 .A\n";
    const auto program = readBytes("a.sin", kSintral);
    ASSERT_TRUE(program);
    EXPECT_EQ(program.value().operations.size(), 4u); // in, rack, knit, out
    std::ofstream(m_folder / "b.jac") << "1002 .a\n";
    const auto bad = readBytes("b.sin", kSintral);
    ASSERT_EQ(bad.diagnostics().size(), 1u);
    EXPECT_EQ(bad.diagnostics()[0].id, "KS0153");
    EXPECT_EQ(bad.diagnostics()[0].place.file, (m_folder / "b.jac").string());
}

TEST_F(ReadProgram, SaysThatWktIsNotDocumented) {
    const auto result = readBytes("a.WKT", "anything");
    ASSERT_EQ(result.diagnostics().size(), 1u);
    EXPECT_EQ(result.diagnostics()[0].id, "KS0020");
    EXPECT_THAT(toLine(result.diagnostics()[0]), testing::HasSubstr("not publicly documented"));
    EXPECT_THAT(toLine(result.diagnostics()[0]), testing::HasSubstr("Sintral"));
}

TEST(WriteProgram, ChoosesTheFormatByTheExtension) {
    const auto program =
        knitout::parse(";!knitout-2\n;;Carriers: 1\nin 1\nknit + f1 1\nknit - f1 1\nout 1\n", "a.k").value();
    EXPECT_EQ(writeProgram(program, "x/a.K").value().substr(0, 10), ";!knitout-");
    EXPECT_EQ(writeProgram(program, "a.knitout").value(), writeProgram(program, "a.k").value());
    EXPECT_TRUE(shima_dat::hasSignature(writeProgram(program, "a.dat").value()));
    EXPECT_THAT(writeProgram(program, "x/a.kc").value(), testing::StartsWith("HOME\nRACK:0\n// a.kc\n"));
    for (const char* name : {"a.sin", "a.jac", "a.wkt", "a.setx", "a"}) {
        const auto result = writeProgram(program, name);
        ASSERT_EQ(result.diagnostics().size(), 1u) << name;
        EXPECT_EQ(result.diagnostics()[0].id, "KS0021");
        EXPECT_THAT(toLine(result.diagnostics()[0]), testing::HasSubstr(".dat"));
    }
}

TEST_F(ReadProgram, TellsMissingFilesAndFolders) {
    EXPECT_EQ(readProgram(m_folder / "none.k").diagnostics().at(0).id, "KS0001");
    EXPECT_EQ(readProgram(m_folder).diagnostics().at(0).id, "KS0001");
}

} // namespace
} // namespace knittsim::formats
