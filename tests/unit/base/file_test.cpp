#include "core/base/file.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sys/resource.h>

namespace knittsim {
namespace {

namespace fs = std::filesystem;

/// A folder of its own for each test, removed with it.
class FileTest : public testing::Test {
protected:
    fs::path put(const std::string& name, const std::string& bytes) {
        std::ofstream(m_folder / name, std::ios::binary) << bytes;
        return m_folder / name;
    }

    std::ptrdiff_t entryCount() const { return m_temporary.entryCount(); }

    test::TemporaryFolder m_temporary;
    const std::filesystem::path m_folder = m_temporary.path();
};

/// While it lives no file may grow beyond `bytes`; a write that tries fails instead of ending the program.
class FileSizeLimit {
public:
    explicit FileSizeLimit(rlim_t bytes) : m_handler(std::signal(SIGXFSZ, SIG_IGN)) {
        getrlimit(RLIMIT_FSIZE, &m_before);
        const rlimit limit{bytes, m_before.rlim_max};
        m_works = setrlimit(RLIMIT_FSIZE, &limit) == 0;
    }
    ~FileSizeLimit() {
        setrlimit(RLIMIT_FSIZE, &m_before);
        std::signal(SIGXFSZ, m_handler);
    }
    FileSizeLimit(const FileSizeLimit&) = delete;
    FileSizeLimit& operator=(const FileSizeLimit&) = delete;

    bool works() const { return m_works; }

private:
    rlimit m_before{};
    void (*m_handler)(int);
    bool m_works = false;
};

class ReadFile : public FileTest {};
class WriteFile : public FileTest {};

std::string idOf(const Diagnostics& diagnostics) {
    return diagnostics.size() == 1 ? diagnostics[0].id : std::to_string(diagnostics.size()) + " diagnostics";
}

TEST_F(ReadFile, GivesEveryByte) {
    const std::string bytes("a\0\r\n\xFF", 5);
    EXPECT_EQ(readFile(put("a", bytes)).value(), bytes);
    EXPECT_EQ(readFile(put("empty", "")).value(), "");
}

TEST_F(ReadFile, RefusesMoreThanTheLimit) {
    const std::string bytes(100'000, 'x');
    const fs::path path = put("a", bytes);
    EXPECT_EQ(readFile(path, bytes.size()).value(), bytes);
    const auto result = readFile(path, bytes.size() - 1);
    EXPECT_EQ(idOf(result.diagnostics()), "KS0007");
    EXPECT_EQ(result.diagnostics()[0].place.file, path.string());
    EXPECT_EQ(result.diagnostics()[0].arguments.at(1), "99999");
}

TEST_F(ReadFile, RefusesAnEndlessFile) {
    EXPECT_EQ(idOf(readFile("/dev/zero", 1 << 20).diagnostics()), "KS0007");
}

TEST_F(ReadFile, TellsWhatCannotBeRead) {
    EXPECT_EQ(idOf(readFile(m_folder / "none").diagnostics()), "KS0001");
    EXPECT_EQ(idOf(readFile(m_folder).diagnostics()), "KS0001");
    EXPECT_EQ(idOf(readFile("").diagnostics()), "KS0001");
}

TEST_F(WriteFile, WritesAndReplaces) {
    const fs::path path = m_folder / "a";
    const std::string bytes("\0one\r\n", 6);
    EXPECT_TRUE(writeFileAtomically(path, bytes));
    EXPECT_EQ(readFile(path).value(), bytes);
    EXPECT_TRUE(writeFileAtomically(path, "two"));
    EXPECT_EQ(readFile(path).value(), "two");
    EXPECT_EQ(entryCount(), 1);
}

TEST_F(WriteFile, WritesThroughASymbolicLink) {
    const fs::path target = put("target", "old");
    const fs::path link = m_folder / "link";
    fs::create_symlink(target, link);
    EXPECT_TRUE(writeFileAtomically(link, "new"));
    EXPECT_TRUE(fs::is_symlink(link));
    EXPECT_EQ(readFile(target).value(), "new");
}

TEST_F(WriteFile, KeepsThePermissionsOfTheOldFile) {
    const fs::path path = put("a", "old");
    const fs::perms perms = fs::perms::owner_read | fs::perms::owner_write | fs::perms::owner_exec;
    fs::permissions(path, perms);
    EXPECT_TRUE(writeFileAtomically(path, "new"));
    EXPECT_EQ(fs::status(path).permissions(), perms);
}

TEST_F(WriteFile, LeavesTheOldFileWhenTheDiskTakesNoMore) {
    const fs::path path = put("a", "old");
    const FileSizeLimit limit(10'000);
    if (!limit.works()) {
        GTEST_SKIP() << "the size of files cannot be limited here";
    }
    const auto result = writeFileAtomically(path, std::string(100'000, 'x'));
    EXPECT_EQ(idOf(result.diagnostics()), "KS0002");
    EXPECT_EQ(readFile(path).value(), "old");
    EXPECT_EQ(entryCount(), 1) << "a temporary file was left";
}

TEST_F(WriteFile, LeavesNothingWhereTheNameIsTaken) {
    fs::create_directory(m_folder / "a");
    put("a/inside", "kept");
    EXPECT_EQ(idOf(writeFileAtomically(m_folder / "a", "x").diagnostics()), "KS0002");
    EXPECT_EQ(readFile(m_folder / "a" / "inside").value(), "kept");
    EXPECT_EQ(entryCount(), 1) << "a temporary file was left";
}

TEST_F(WriteFile, TellsAMissingFolder) {
    const auto result = writeFileAtomically(m_folder / "none" / "a", "x");
    EXPECT_EQ(idOf(result.diagnostics()), "KS0002");
    EXPECT_EQ(entryCount(), 0);
}

} // namespace
} // namespace knittsim
