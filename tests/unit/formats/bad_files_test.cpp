// Files that are no machine data, made while the test runs: one clear finding each, bounded memory.

#include "core/base/file.h"
#include "core/base/message_table.h"
#include "core/formats/formats.h"
#include "core/formats/kcode/writer.h"
#include "core/formats/knitout/reader.h"
#include "core/formats/shima_dat/writer.h"
#include "core/machine/profile.h"
#include "core/yarn/yarn_library.h"
#include "tests/support/temporary_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <random>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace knittsim::formats {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

/// Memory that reading a file may take at most.
constexpr long kMaxMegabytes = 400;
constexpr std::size_t kHundredMegabytes = std::size_t{100} << 20;
/// The largest files of short lines that are read at all.
constexpr std::size_t kJustReadable = kMaxFileBytes - 1000;

struct Kind {
    const char* name;   ///< of the format, and the file's name
    std::string sample; ///< a file that opens
};

void PrintTo(const Kind& kind, std::ostream* out) {
    *out << kind.name;
}

std::string fileText(const fs::path& path) {
    return readFile(path).value();
}

std::vector<Kind> kinds() {
    const std::string knitout =
        ";!knitout-2\n;;Carriers: 1 2\nin 1\nknit + f1 1\nknit + f2 1\ntuck - f2 1\nxfer f1 b1\nout 1\n";
    const machine::Program program = knitout::parse(knitout, "a.k").value();
    const fs::path resources = fs::path(KNITTSIM_SOURCE_DIR) / "resources";
    return {{"a.k", knitout},
            {"a.dat", shima_dat::write(program).value()},
            {"a.kc", kcode::write(program, "a.kc").value()},
            {"a.sin", "START\n10 SEN=1-6\n30 << S:<0+>R-0; Y:1; S1\nEND\n"},
            {"a.jac", "1002 .A2(A.)$\n1003 $A\n"},
            {"machine.json", fileText(resources / "machines" / "kniterate.json")},
            {"yarn.json", fileText(resources / "yarns" / "merino-2-30.json")}};
}

/// While it lives an administrator may do no more than anyone else.
class WithoutPrivileges {
public:
    WithoutPrivileges() : m_before(geteuid()) {
        if (m_before == 0) {
            EXPECT_EQ(seteuid(kNobody), 0);
        }
    }
    ~WithoutPrivileges() { EXPECT_EQ(seteuid(m_before), 0); }
    WithoutPrivileges(const WithoutPrivileges&) = delete;
    WithoutPrivileges& operator=(const WithoutPrivileges&) = delete;

private:
    static constexpr uid_t kNobody = 65534;
    uid_t m_before;
};

class BadFile : public testing::TestWithParam<Kind> {
protected:
    void SetUp() override {
        if (is("a.jac")) {
            std::ofstream(m_folder / "a.sin") << "<< S:A-0; Y:1; S1\n";
        }
    }

    bool is(const std::string& name) const { return GetParam().name == name; }
    bool isText() const { return !is("a.dat"); }
    bool isJson() const { return is("machine.json") || is("yarn.json"); }
    fs::path path() const { return m_folder / GetParam().name; }

    void put(const std::string& bytes) const { std::ofstream(path(), std::ios::binary) << bytes; }

    /// `line` again and again.
    void putMany(const std::string& line, std::size_t size) const {
        std::string bytes;
        bytes.reserve(size);
        while (bytes.size() + line.size() <= size) {
            bytes += line;
        }
        put(bytes);
    }

    /// What is said about the file; empty when it opens without a word.
    Diagnostics findings() const {
        if (is("machine.json")) {
            return machine::readMachineProfile(path()).diagnostics();
        }
        if (is("yarn.json")) {
            return yarn::readYarn(path()).diagnostics();
        }
        return readProgram(is("a.jac") ? m_folder / "a.sin" : path()).diagnostics();
    }

    /// The only finding as a line that names the file; an explanation where there are several.
    std::string onlyLine() const {
        const Diagnostics found = findings();
        if (found.size() != 1) {
            std::string text = std::to_string(found.size()) + " findings";
            for (const Diagnostic& finding : found) {
                text += '\n' + toLine(finding);
            }
            return text;
        }
        EXPECT_FALSE(cureText(found[0]).empty()) << found[0].id;
        EXPECT_THAT(toLine(found[0]), testing::StartsWith(path().string() + ':'));
        EXPECT_LT(toLine(found[0]).size(), path().string().size() + 400);
        return toLine(found[0]);
    }

    /// Megabytes that a process of its own has taken at most when it has read the file.
    long megabytesToRead() const {
        const pid_t child = fork();
        if (child == 0) {
            const Diagnostics found = findings();
            _exit(found.empty() ? 1 : 0);
        }
        int status = 0;
        rusage usage{};
        EXPECT_EQ(wait4(child, &status, 0, &usage), child);
        EXPECT_TRUE(WIFEXITED(status));
        return usage.ru_maxrss / 1024;
    }

    test::TemporaryFolder m_temporary;
    const std::filesystem::path m_folder = m_temporary.path();
};

TEST_P(BadFile, TheSampleOpens) {
    put(GetParam().sample);
    EXPECT_FALSE(hasErrors(findings())) << toLine(findings().front());
}

TEST_P(BadFile, AnEmptyFileIsSaidToBeEmpty) {
    put("");
    EXPECT_THAT(onlyLine(), HasSubstr(is("a.dat") ? "KS0130" : "KS0012: The file is empty."));
}

TEST_P(BadFile, AFolderCannotBeRead) {
    fs::create_directory(path());
    EXPECT_THAT(onlyLine(), HasSubstr("KS0001: The file cannot be read: Is a directory."));
}

TEST_P(BadFile, AFileThatMayNotBeReadCannotBeRead) {
    put(GetParam().sample);
    fs::permissions(path(), fs::perms::none);
    fs::permissions(m_folder, fs::perms::all);
    const WithoutPrivileges user;
    EXPECT_THAT(onlyLine(), HasSubstr("KS0001: The file cannot be read: Permission denied."));
}

TEST_P(BadFile, OtherEncodingsAreNamed) {
    std::string wide;
    std::string widest;
    for (const char c : GetParam().sample) {
        wide += {c, '\0'};
        widest += {c, '\0', '\0', '\0'};
    }
    put("\xFF\xFE" + wide);
    EXPECT_THAT(onlyLine(),
                HasSubstr(isText() ? ":1:1: error KS0013: The file is text in UTF-16" : "KS0130"));
    put(std::string("\xFF\xFE\0\0", 4) + widest);
    EXPECT_THAT(onlyLine(),
                HasSubstr(isText() ? ":1:1: error KS0013: The file is text in UTF-32" : "KS0130"));
}

TEST_P(BadFile, AByteOrderMarkIsNoMoreThanAWarning) {
    put("\xEF\xBB\xBF" + GetParam().sample);
    if (isText()) {
        EXPECT_FALSE(hasErrors(findings())) << onlyLine();
    } else {
        EXPECT_THAT(onlyLine(), HasSubstr("KS0130"));
    }
}

TEST_P(BadFile, NulBytesAreFoundAtTheirPlace) {
    const std::string& sample = GetParam().sample;
    const std::size_t end = sample.find('\n') + 1;
    if (isText()) {
        put(sample.substr(0, end) + "ab" + std::string(3, '\0') + sample.substr(end));
        EXPECT_THAT(onlyLine(), HasSubstr(":2:3: error KS0122"));
    }
    put(std::string(std::size_t{1} << 20, '\0'));
    EXPECT_THAT(onlyLine(), HasSubstr(isText() ? ":1:1: error KS0122" : "KS0130"));
}

TEST_P(BadFile, NoiseIsRefusedInOneSentence) {
    std::mt19937 random(3);
    std::string noise(20'000, '\0');
    for (char& c : noise) {
        c = static_cast<char>(random() % 256);
    }
    put(noise);
    EXPECT_THAT(onlyLine(), HasSubstr(isText() ? "KS0122" : "KS0130"));
    std::ranges::replace(noise, '\0', '\1');
    put(noise);
    EXPECT_THAT(onlyLine(), HasSubstr(isText() ? "KS0014: This is not a text file" : "KS0130"));
}

TEST_P(BadFile, OtherTextIsRefusedInOneSentence) {
    putMany("It was a bright cold day in April, and the needles were striking thirteen.\n", 100'000);
    const std::string line = onlyLine();
    if (is("a.k") || is("a.sin")) {
        EXPECT_THAT(line, HasSubstr(":1:1: error KS0127: This does not look like a"));
        EXPECT_THAT(line, HasSubstr("'It'"));
    } else {
        EXPECT_THAT(line, HasSubstr(is("a.dat")   ? "KS0130"
                                    : is("a.kc")  ? "KS0140"
                                    : is("a.jac") ? "KS0153"
                                                  : "KS0003"));
    }
}

TEST_P(BadFile, LatinLettersOpenWithAWarningOrGiveOneError) {
    const std::string latin = "M\xFCtze";
    const std::string& sample = GetParam().sample;
    put(is("a.k")     ? sample + ";" + latin + "\n"
        : is("a.kc")  ? sample + "// " + latin + "\n"
        : is("a.sin") ? "C " + latin + "\n" + sample
                      : sample + latin);
    const std::string line = onlyLine();
    EXPECT_THAT(line, HasSubstr(is("a.k") || is("a.kc") || is("a.sin") ? "warning KS0113"
                                : is("a.dat")                          ? "KS0131"
                                : isJson()                             ? "KS0003"
                                                                       : "KS0153"));
}

TEST_P(BadFile, ACutFileIsToldInOneSentence) {
    const std::string& sample = GetParam().sample;
    // In the middle of an operation where each stands by itself.
    put(sample.substr(0, is("a.k")     ? sample.find("xfer") + 5
                         : is("a.kc")  ? sample.rfind('.') - 3
                         : is("a.sin") ? sample.find("Y:") + 1
                         : is("a.jac") ? sample.find('(') + 2
                                       : sample.size() * 2 / 3));
    EXPECT_THAT(onlyLine(), HasSubstr("error KS"));
}

TEST_P(BadFile, AHundredMegabytesAreTooMuch) {
    const char* expected = isJson() ? "the limit is 1048576" : "the limit is 33554432";
    put(std::string(kHundredMegabytes, '9'));
    EXPECT_THAT(onlyLine(), HasSubstr(expected));
    EXPECT_LT(megabytesToRead(), kMaxMegabytes);
    putMany("a\n", kHundredMegabytes);
    EXPECT_THAT(onlyLine(), HasSubstr(expected));
    EXPECT_LT(megabytesToRead(), kMaxMegabytes);
}

/// Just below the limit the content decides; memory stays bounded.
TEST_P(BadFile, TheLargestFilesThatAreReadTakeBoundedMemory) {
    if (isJson()) {
        const std::size_t size = (std::size_t{1} << 20) - 10;
        put(std::string(size, '['));
        EXPECT_THAT(onlyLine(), HasSubstr("KS0003"));
        putMany("{\"a\":", size);
        EXPECT_THAT(onlyLine(), HasSubstr("KS0003"));
        EXPECT_LT(megabytesToRead(), kMaxMegabytes);
        return;
    }
    put(std::string(kJustReadable, '9'));
    EXPECT_THAT(onlyLine(), HasSubstr(isText() ? ":1:1: error KS0116" : "KS0130"));
    putMany("a\n", kJustReadable);
    EXPECT_THAT(onlyLine(), HasSubstr("error KS01"));
    EXPECT_LT(megabytesToRead(), kMaxMegabytes);
    const std::string begin = GetParam().sample;
    putMany(is("a.k") ? "pause\n" : is("a.sin") ? "<< S:<0+>R-0; Y:1; S1\n" : begin, kJustReadable);
    EXPECT_LT(megabytesToRead(), kMaxMegabytes);
}

TEST_P(BadFile, HugeNumbersGiveFewFindings) {
    std::string bytes;
    for (const char c : GetParam().sample) {
        bytes += std::isdigit(static_cast<unsigned char>(c)) != 0 ? std::string(20, '9') : std::string(1, c);
    }
    put(bytes);
    const Diagnostics found = findings();
    EXPECT_GE(found.size(), 1u);
    EXPECT_LE(found.size(), 22u);
}

INSTANTIATE_TEST_SUITE_P(Formats, BadFile, testing::ValuesIn(kinds()), [](const auto& info) {
    std::string name = info.param.name;
    std::ranges::replace(name, '.', '_');
    return name;
});

} // namespace
} // namespace knittsim::formats
