#include "tests/support/temporary_folder.h"
#include "ui/render/image.h"

#include <gtest/gtest.h>

#include <filesystem>

namespace knittsim::render {
namespace {

class ImageFile : public testing::Test {
protected:
    test::TemporaryFolder m_folder;
    const std::filesystem::path m_path = m_folder / "image.png";
};

TEST_F(ImageFile, comesBackAsItWasWritten) {
    Image image{3, 2, {}};
    for (int i = 0; i < 24; ++i) {
        image.pixels.push_back(static_cast<std::uint8_t>(i * 10));
    }
    image.pixels[3] = 255;
    ASSERT_TRUE(writePng(m_path, image));
    const auto read = readPng(m_path);
    ASSERT_TRUE(read);
    EXPECT_EQ(read->width, 3);
    EXPECT_EQ(read->height, 2);
    EXPECT_EQ(read->pixels, image.pixels);
    EXPECT_EQ(read->at(1, 1)[0], image.pixels[16]);
}

TEST_F(ImageFile, emptyImageIsAnErrorAndWritesNothing) {
    const auto written = writePng(m_path, Image{});
    ASSERT_FALSE(written);
    EXPECT_EQ(written.diagnostics().front().id, "KS0404");
    EXPECT_FALSE(std::filesystem::exists(m_path));
}

TEST_F(ImageFile, cancelledWriteLeavesNothing) {
    Image image{4, 200, std::vector<std::uint8_t>(3200, 77)};
    int asked = 0;
    const auto written = writePng(m_path, image, [&asked](double) { return ++asked < 2; });
    ASSERT_FALSE(written);
    EXPECT_EQ(written.diagnostics().front().id, "KS0009");
    EXPECT_FALSE(std::filesystem::exists(m_path));
}

TEST_F(ImageFile, foreignBytesAreAnError) {
    ASSERT_TRUE(writeFileAtomically(m_path, "this is no picture"));
    const auto read = readPng(m_path);
    ASSERT_FALSE(read);
    EXPECT_EQ(read.diagnostics().front().id, "KS0405");
}

} // namespace
} // namespace knittsim::render
