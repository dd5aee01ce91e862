#include "core/base/file.h"
#include "core/base/message_table.h"
#include "core/formats/kcode/reader.h"
#include "core/formats/kcode/writer.h"
#include "core/formats/knitout/reader.h"
#include "core/formats/shima_dat/reader.h"
#include "core/formats/shima_dat/writer.h"
#include "tests/support/same_meaning.h"
#include "tests/support/machine_data.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace knittsim::formats {
namespace {

namespace fs = std::filesystem;

std::string bytesOf(const fs::path& path) {
    auto file = readFile(path);
    return file ? std::move(file).value() : std::string();
}

std::string said(const Diagnostics& diagnostics) {
    return diagnostics.empty() ? std::string() : toLine(diagnostics.front());
}

/// Where two texts begin to differ, for the message of a failed test.
std::string firstDifference(const std::string& a, const std::string& b) {
    const auto at = std::mismatch(a.begin(), a.end(), b.begin(), b.end()).first - a.begin();
    return a == b ? std::string()
                  : "byte " + std::to_string(at) + " of " + std::to_string(a.size()) + " and " +
                        std::to_string(b.size());
}

/// The picture knit.dat was made from another version of the program: in the two passes of carrier 5 it tucks
/// at twelve rear needles where knit.k knits, and at four front needles where knit.k misses.
void makeLikePicture(machine::Program& program) {
    for (machine::Operation& op : program.operations) {
        const bool fifth = op.carriers.size() == 1 && op.carriers[0] == 4;
        const bool rearKnit = op.kind == machine::OperationKind::Knit && op.needle.bed == machine::Bed::Rear;
        const bool edgeMiss =
            op.kind == machine::OperationKind::Miss && (op.needle.index == 216 || op.needle.index == 277);
        if (fifth && (rearKnit || edgeMiss)) {
            op.kind = machine::OperationKind::Tuck;
        }
    }
}

class DatPair : public testing::TestWithParam<const char*> {
protected:
    void SetUp() override {
        const fs::path folder = test::machineData() / "loopsense";
        m_knitout = bytesOf(folder / (std::string(GetParam()) + ".k"));
        m_dat = bytesOf(folder / (std::string(GetParam()) + ".dat"));
        if (m_knitout.empty() || m_dat.empty()) {
            GTEST_SKIP() << "no machine data in " << folder;
        }
    }

    machine::Program knitoutProgram() const {
        auto program = knitout::parse(m_knitout, "a.k");
        EXPECT_TRUE(program) << said(program.diagnostics());
        if (GetParam() == std::string("knit")) {
            makeLikePicture(program.value());
        }
        return std::move(program).value();
    }

    std::string m_knitout;
    std::string m_dat;
};

TEST_P(DatPair, IsWrittenByteForByte) {
    const auto written = shima_dat::write(knitoutProgram());
    ASSERT_TRUE(written) << said(written.diagnostics());
    EXPECT_EQ(firstDifference(written.value(), m_dat), "");
}

TEST_P(DatPair, MeansTheSameAsItsKnitout) {
    const auto dat = shima_dat::parse(m_dat, "a.dat");
    ASSERT_TRUE(dat) << said(dat.diagnostics());
    EXPECT_EQ(said(dat.diagnostics()), "");
    EXPECT_EQ(test::differenceInMeaning(knitoutProgram(), dat.value()), "");
}

TEST_P(DatPair, IsWrittenAgainAsItWas) {
    const auto dat = shima_dat::parse(m_dat, "a.dat");
    ASSERT_TRUE(dat) << said(dat.diagnostics());
    const auto written = shima_dat::write(dat.value());
    ASSERT_TRUE(written) << said(written.diagnostics());
    EXPECT_EQ(firstDifference(written.value(), m_dat), "");
}

INSTANTIATE_TEST_SUITE_P(Loopsense, DatPair, testing::Values("knit", "tuck-A"));

struct KcodeFile {
    const char* name;
    const char* title; ///< file name that the text carries
    int shift;         ///< from needle numbers of the knitout to those on the bed
};

class KcodePair : public testing::TestWithParam<KcodeFile> {
protected:
    void SetUp() override {
        const fs::path folder = test::machineData() / "kniterate-backend";
        m_knitout = bytesOf(folder / (std::string(GetParam().name) + ".k"));
        m_kcode = bytesOf(folder / (std::string(GetParam().name) + ".kc"));
        if (m_knitout.empty() || m_kcode.empty()) {
            GTEST_SKIP() << "no machine data in " << folder;
        }
    }

    std::string m_knitout;
    std::string m_kcode;
};

/// The tool that wrote split.kc names leftward splits as if they went right.
std::string withLeftwardSplits(std::string text) {
    const std::string old = "<< Tr-Rr 1";
    for (std::size_t at = text.find(old); at != std::string::npos; at = text.find(old)) {
        text.replace(at, old.size(), "<< Tr-Rl 1");
    }
    return text;
}

TEST_P(KcodePair, IsWrittenAsTheSameText) {
    const auto program = knitout::parse(m_knitout, "a.k");
    ASSERT_TRUE(program) << said(program.diagnostics());
    const auto written = kcode::write(program.value(), GetParam().title);
    ASSERT_TRUE(written) << said(written.diagnostics());
    EXPECT_EQ(firstDifference(written.value(), withLeftwardSplits(m_kcode)), "");
}

TEST_P(KcodePair, MeansTheSameAsItsKnitout) {
    const auto program = knitout::parse(m_knitout, "a.k");
    const auto read = kcode::parse(m_kcode, "a.kc");
    ASSERT_TRUE(program && read) << said(read.diagnostics());
    EXPECT_EQ(said(read.diagnostics()), "");
    EXPECT_EQ(test::differenceInMeaning(program.value(), read.value(), GetParam().shift), "");
}

INSTANTIATE_TEST_SUITE_P(Kniterate, KcodePair,
                         testing::Values(KcodeFile{"position-center", "position-center.kc", 128},
                                         KcodeFile{"position-keep", "position-keep.kc", 0},
                                         KcodeFile{"position-left", "position-left.kc", 11},
                                         KcodeFile{"position-right", "position-right.kc", 245},
                                         KcodeFile{"small-square", "small-square.kc", 0},
                                         KcodeFile{"split", "./tests/split.kc", 123},
                                         KcodeFile{"xfer-style", "xfer-style.kc", 0}),
                         [](const auto& info) {
                             std::string name = info.param.name;
                             std::replace(name.begin(), name.end(), '-', '_');
                             return name;
                         });

} // namespace
} // namespace knittsim::formats
