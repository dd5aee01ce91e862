#include "tests/golden/pictures.h"
#include "tests/support/build.h"
#include "tests/support/lattice.h"
#include "ui/render/frame_target.h"
#include "ui/render/level_of_detail.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <string>

namespace knittsim::render {
namespace {

constexpr int kWidth = 320;
constexpr int kHeight = 240;
constexpr float kDiameterMm = static_cast<float>(kLoopMm) / 9;

/// Yarn drawn as windows draw it, at any width on the screen.
class DetailPictures : public testing::Test {
protected:
    void SetUp() override {
        if (!rendererName().starts_with("llvmpipe")) {
            GTEST_SKIP() << "differences are known for llvmpipe";
        }
        m_context = std::move(EglContext::create().value());
        m_renderer = std::move(FabricRenderer::create().value());
        std::string lines = "in 1\n";
        for (int course = 0; course < 30; ++course) {
            lines += course % 2 == 0 ? test::pass("knit", 'f', 30, 0, 1) : test::pass("knit", 'f', 0, 30, 1);
        }
        m_fabric = std::make_shared<fabric::Fabric>(test::build(lines + "out 1\n"));
        YarnLook look;
        look.colour = {186, 92, 70};
        look.diameterMm = kDiameterMm;
        look.hairiness = 0.6;
        m_looks = {look, look};
        FabricScene scene(m_fabric, m_looks, DrawStyle::Yarn);
        m_frame = scene.prepare(test::relaxedLattice(*m_fabric, kLoopMm));
        ASSERT_TRUE(m_renderer->upload(m_frame));
        m_renderer->setLooks(m_looks);
    }

    View viewAt(float diameterPixels, Quality quality) const {
        View view;
        view.width = kWidth;
        view.height = kHeight;
        view.quality = quality;
        view.camera.setViewport(kWidth, kHeight);
        view.camera.setScene(m_frame->bounds);
        CameraState state = view.camera.state();
        state.target = m_frame->bounds.centre();
        state.halfHeight = 0.5F * kHeight * kDiameterMm / diameterPixels;
        view.camera.setState(state);
        return view;
    }

    Image draw(const View& view) {
        const auto target = FrameTarget::create(kWidth, kHeight, 4);
        EXPECT_TRUE(target);
        target.value()->bind();
        m_renderer->draw(view);
        return target.value()->read();
    }

    /// Detail just below and above a width where it changes.
    struct Step {
        float pixels;
        Quality quality;
    };
    std::vector<Step> steps() const {
        std::vector<Step> found;
        for (const Quality quality : {Quality::Fast, Quality::Best}) {
            const auto at = [&](float pixels) {
                return detailAt(pixels, m_frame->segmentMm / kDiameterMm, quality);
            };
            for (float pixels = 1; pixels < 60; pixels += 0.01F) {
                const Detail before = at(pixels);
                const Detail after = at(pixels + 0.01F);
                if (before.sides != after.sides || before.stride != after.stride) {
                    found.push_back({pixels, quality});
                }
            }
        }
        return found;
    }

    std::unique_ptr<EglContext> m_context; // first: it goes last
    std::unique_ptr<FabricRenderer> m_renderer;
    std::shared_ptr<const fabric::Fabric> m_fabric;
    std::vector<YarnLook> m_looks;
    std::shared_ptr<const SceneFrame> m_frame;
};

/// What the eye compares when a picture changes at once: the colour of small areas.
struct Difference {
    double mean = 0;  ///< of areas, 0 .. 255
    double whole = 0; ///< of the colour of the whole picture
};

Difference compare(const Image& a, const Image& b) {
    constexpr int kArea = 8;
    Difference result;
    int areas = 0;
    for (int channel = 0; channel < 3; ++channel) {
        double all = 0;
        for (int y = 0; y + kArea <= a.height; y += kArea) {
            for (int x = 0; x + kArea <= a.width; x += kArea) {
                int sum = 0;
                for (int i = 0; i < kArea * kArea; ++i) {
                    const int px = x + i % kArea;
                    const int py = y + i / kArea;
                    sum += a.at(px, py)[channel] - b.at(px, py)[channel];
                }
                result.mean += std::abs(sum) / double(kArea * kArea);
                all += sum / double(kArea * kArea);
                ++areas;
            }
        }
        result.whole = std::max(result.whole, std::abs(all) / (areas / (channel + 1.0)));
    }
    result.mean /= areas;
    return result;
}

TEST_F(DetailPictures, noStepFromLevelToLevelIsSeen) {
    ASSERT_GE(steps().size(), 6U); // strokes, tubes, yarn, finer yarn: each for both qualities
    for (const Step& step : steps()) {
        const Image before = draw(viewAt(step.pixels, step.quality));
        const Image after = draw(viewAt(step.pixels + 0.01F, step.quality));
        const Difference difference = compare(before, after);
        const char* quality = step.quality == Quality::Best ? "best" : "fast";
        EXPECT_LT(difference.mean, 3) << step.pixels << ' ' << quality;
        EXPECT_LT(difference.whole, 3) << step.pixels << ' ' << quality;
    }
}

/// A level that a person has fixed is what is drawn, and another picture.
TEST_F(DetailPictures, aFixedLevelIsDrawnAtAnyDistance) {
    for (const float pixels : {3.0F, 30.0F}) {
        View view = viewAt(pixels, Quality::Best);
        std::vector<Image> pictures;
        for (const DetailLevel level : {DetailLevel::Strokes, DetailLevel::Tubes, DetailLevel::Yarn}) {
            view.level = level;
            EXPECT_EQ(levelDrawn(*m_frame, m_looks, view), level);
            pictures.push_back(draw(view));
        }
        EXPECT_GT(compare(pictures[1], pictures[2]).mean, 0.2) << pixels;
        view.level.reset();
        const Image automatic = draw(view);
        EXPECT_EQ(compare(automatic, pictures[pixels < 9 ? 0 : 2]).mean, 0) << pixels;
    }
}

} // namespace
} // namespace knittsim::render
