#include "core/base/file.h"
#include "core/base/message_table.h"
#include "core/formats/knitout/reader.h"
#include "core/formats/shima_dat/reader.h"
#include "core/formats/shima_dat/writer.h"
#include "tests/unit/formats/machine_data.h"
#include "tests/unit/formats/same_meaning.h"

#include <gtest/gtest.h>

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

    std::string m_knitout;
    std::string m_dat;
};

TEST_P(DatPair, IsWrittenByteForByte) {
    const auto program = knitout::parse(m_knitout, "a.k");
    ASSERT_TRUE(program) << said(program.diagnostics());
    const auto written = shima_dat::write(program.value());
    ASSERT_TRUE(written) << said(written.diagnostics());
    EXPECT_EQ(firstDifference(written.value(), m_dat), "");
}

TEST_P(DatPair, MeansTheSameAsItsKnitout) {
    const auto knitout = knitout::parse(m_knitout, "a.k");
    const auto dat = shima_dat::parse(m_dat, "a.dat");
    ASSERT_TRUE(knitout && dat) << said(dat.diagnostics());
    EXPECT_EQ(said(dat.diagnostics()), "");
    EXPECT_EQ(test::differenceInMeaning(knitout.value(), dat.value()), "");
}

TEST_P(DatPair, IsWrittenAgainAsItWas) {
    const auto dat = shima_dat::parse(m_dat, "a.dat");
    ASSERT_TRUE(dat) << said(dat.diagnostics());
    const auto written = shima_dat::write(dat.value());
    ASSERT_TRUE(written) << said(written.diagnostics());
    EXPECT_EQ(firstDifference(written.value(), m_dat), "");
}

INSTANTIATE_TEST_SUITE_P(Loopsense, DatPair, testing::Values("knit", "tuck-A"));

} // namespace
} // namespace knittsim::formats
