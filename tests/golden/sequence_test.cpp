#include "tests/support/build.h"
#include "tests/support/lattice.h"
#include "tests/support/temporary_folder.h"
#include "ui/render/egl_context.h"
#include "ui/render/picture_sequence.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <memory>

namespace knittsim::render {
namespace {

namespace fs = std::filesystem;

class PictureSequence : public testing::Test {
protected:
    void SetUp() override {
        if (!EglContext::create()) {
            GTEST_SKIP() << "no OpenGL";
        }
        m_look.fabric = &m_fabric;
        m_look.width = 64;
        m_look.height = 48;
        for (const float factor : {1.0F, 0.8F, 0.6F}) {
            std::vector<float> places = test::relaxedLattice(m_fabric, 5);
            for (float& place : places) {
                place *= factor;
            }
            m_shapes.push_back({std::move(places)});
        }
    }
    fabric::Fabric m_fabric = test::build("in 1\n" + test::pass("knit", 'f', 3, 0, 1) +
                                          test::pass("knit", 'f', 0, 3, 1) + "out 1\n");
    RenderRequest m_look;
    std::vector<simulation::SettlingShape> m_shapes;
    test::TemporaryFolder m_folder;
};

TEST_F(PictureSequence, HasOneNumberedPictureForEachShapeFromOnePlace) {
    ASSERT_TRUE(writeSequence(m_folder / "frames", m_look, m_shapes));
    EXPECT_EQ(m_folder.entryCount(), 1);
    const auto first = readPng(m_folder / "frames/0001.png");
    const auto last = readPng(m_folder / "frames/0003.png");
    ASSERT_TRUE(first && last);
    EXPECT_FALSE(fs::exists(m_folder / "frames/0004.png"));
    EXPECT_EQ(first->width, 64);
    // The camera stays, so that the fabric is seen to shrink: more of the last picture is ground.
    const auto ground = [](const Image& image) {
        int count = 0;
        for (int y = 0; y < image.height; ++y) {
            for (int x = 0; x < image.width; ++x) {
                count += std::abs(image.at(x, y)[0] - image.at(0, y)[0]) < 4 ? 1 : 0;
            }
        }
        return count;
    };
    EXPECT_GT(ground(last.value()), ground(first.value()) + 200);
}

TEST_F(PictureSequence, NothingIsLeftWhenItIsCancelled) {
    int asked = 0;
    const auto written =
        writeSequence(m_folder / "frames", m_look, m_shapes, [&asked](double) { return ++asked < 3; });
    ASSERT_FALSE(written);
    EXPECT_EQ(written.diagnostics().front().id, "KS0009");
    EXPECT_EQ(m_folder.entryCount(), 0);
}

TEST_F(PictureSequence, WhatIsThereStays) {
    fs::create_directories(m_folder / "frames");
    std::ofstream(m_folder / "frames/mine.txt") << "mine";
    const auto written = writeSequence(m_folder / "frames", m_look, m_shapes);
    ASSERT_FALSE(written);
    EXPECT_EQ(written.diagnostics().front().id, "KS0002");
    EXPECT_TRUE(fs::exists(m_folder / "frames/mine.txt"));
    EXPECT_EQ(m_folder.entryCount(), 1);
}

TEST_F(PictureSequence, WhatACrashLeftIsNoObstacle) {
    fs::create_directories(m_folder / "frames.part1");
    ASSERT_TRUE(writeSequence(m_folder / "frames", m_look, m_shapes));
    EXPECT_TRUE(fs::exists(m_folder / "frames/0003.png"));
    EXPECT_EQ(m_folder.entryCount(), 2);
}

TEST_F(PictureSequence, APictureThatCannotBeMadeLeavesNothing) {
    m_look.width = 0;
    EXPECT_FALSE(writeSequence(m_folder / "frames", m_look, m_shapes));
    EXPECT_EQ(m_folder.entryCount(), 0);
}

} // namespace
} // namespace knittsim::render
