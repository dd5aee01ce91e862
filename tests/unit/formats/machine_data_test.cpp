#include "core/base/message_table.h"
#include "core/formats/formats.h"
#include "core/formats/knitout/reader.h"
#include "core/formats/knitout/writer.h"
#include "tests/support/compare_programs.h"
#include "tests/support/machine_data.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

namespace knittsim::formats {
namespace {

namespace fs = std::filesystem;

using test::machineData;

std::vector<fs::path> filesWith(std::initializer_list<const char*> extensions) {
    std::vector<fs::path> files;
    std::error_code error;
    for (const auto& entry : fs::recursive_directory_iterator(machineData(), error)) {
        for (const char* extension : extensions) {
            if (entry.path().extension() == extension) {
                files.push_back(entry.path());
            }
        }
    }
    return files;
}

TEST(MachineData, KnitoutFilesOpenAndSurviveARoundTrip) {
    const auto files = filesWith({".k", ".knitout"});
    if (files.empty()) {
        GTEST_SKIP() << "no knitout files in " << machineData();
    }
    for (const fs::path& file : files) {
        const auto program = readProgram(file);
        ASSERT_TRUE(program) << toLine(program.diagnostics().front());
        EXPECT_FALSE(program.value().operations.empty()) << file;
        const auto again = knitout::parse(knitout::write(program.value()), "again.k");
        ASSERT_TRUE(again) << file;
        EXPECT_EQ(test::difference(program.value(), again.value()), "") << file;
    }
}

TEST(MachineData, OtherFormatsOpenWithoutAFinding) {
    const auto files = filesWith({".dat", ".kc"});
    if (files.empty()) {
        GTEST_SKIP() << "no Shima or Kniterate files in " << machineData();
    }
    for (const fs::path& file : files) {
        const auto result = readProgram(file);
        EXPECT_TRUE(result.diagnostics().empty()) << toLine(result.diagnostics().front());
        ASSERT_TRUE(result) << file;
        EXPECT_FALSE(result.value().operations.empty()) << file;
    }
}

} // namespace
} // namespace knittsim::formats
