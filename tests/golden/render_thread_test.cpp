#include "tests/golden/blocks.h"
#include "tests/support/build.h"
#include "tests/support/lattice.h"
#include "ui/render/offscreen.h"
#include "ui/render/render_thread.h"

#include <gtest/gtest.h>

#include <atomic>

namespace knittsim::render {
namespace {

class Threaded : public testing::Test {
protected:
    void SetUp() override {
        auto started = RenderThread::start([this] { ++m_called; });
        if (!started) {
            GTEST_SKIP() << "no OpenGL without a window here: " << started.diagnostics().front().id;
        }
        m_thread = std::move(started.value());
    }

    RenderThread::Request request(int width, int height) {
        FabricScene scene(m_fabric, m_looks, DrawStyle::Strokes);
        RenderThread::Request request;
        request.scene = scene.prepare(m_positions);
        request.looks = m_looks;
        request.view.width = width;
        request.view.height = height;
        request.view.camera.setViewport(width, height);
        request.view.camera.setScene(request.scene->bounds);
        request.view.camera.fit(request.scene->bounds);
        return request;
    }

    std::shared_ptr<const fabric::Fabric> m_fabric = std::make_shared<fabric::Fabric>(test::build(
        "in 1\n" + test::pass("knit", 'f', 4, 0, 1) + test::pass("knit", 'f', 0, 4, 1) + "out 1\n"));
    std::vector<float> m_positions = test::relaxedLattice(*m_fabric, 5);
    std::vector<YarnLook> m_looks = std::vector<YarnLook>(4);
    std::atomic<int> m_called = 0;
    std::unique_ptr<RenderThread> m_thread;
};

TEST_F(Threaded, endsWithThePictureOfTheLastRequest) {
    for (int i = 0; i < 20; ++i) {
        m_thread->post(request(60 + i, 40));
    }
    m_thread->post(request(96, 66));
    m_thread->wait();
    const auto picture = m_thread->take();
    ASSERT_TRUE(picture);
    EXPECT_GT(m_called.load(), 0);
    EXPECT_FALSE(m_thread->take());
    ASSERT_EQ(picture->image.width, 96);
    ASSERT_EQ(picture->image.height, 66);
    if (picture->quality == Quality::Best) {
        RenderRequest same;
        same.fabric = m_fabric.get();
        same.positions = m_positions;
        same.looks = m_looks;
        same.style = DrawStyle::Strokes;
        same.width = 96;
        same.height = 66;
        const auto image = renderFabric(same);
        ASSERT_TRUE(image);
        EXPECT_EQ(test::compareBlocks(image.value(), picture->image).blocks, 0);
    }
}

TEST_F(Threaded, withoutASceneDrawsTheBackgroundOnly) {
    RenderThread::Request empty;
    empty.view.width = 12;
    empty.view.height = 9;
    empty.view.dark = true;
    m_thread->post(empty);
    m_thread->wait();
    const auto picture = m_thread->take();
    ASSERT_TRUE(picture);
    EXPECT_GT(picture->image.at(5, 1)[1], picture->image.at(5, 8)[1]); // lighter above
    EXPECT_EQ(picture->image.at(1, 4)[1], picture->image.at(10, 4)[1]);
}

TEST_F(Threaded, aContextThatIsLostIsMadeAnewWithTheSamePicture) {
    m_thread->post(request(96, 66));
    m_thread->wait();
    const auto before = m_thread->take();
    ASSERT_TRUE(before);

    std::atomic<int> checks = 0;
    const auto started = RenderThread::start([] {}, [&checks] { return ++checks == 2; });
    ASSERT_TRUE(started);
    started.value()->post(request(60, 40));
    started.value()->wait(); // lost while the best picture is drawn, or with the next request
    started.value()->post(request(96, 66));
    started.value()->wait();
    const auto after = started.value()->take();
    EXPECT_GT(checks.load(), 2);
    EXPECT_TRUE(started.value()->failure().empty());
    ASSERT_TRUE(after);
    ASSERT_EQ(after->image.width, 96);
    if (before->quality == after->quality) {
        EXPECT_EQ(test::compareBlocks(before->image, after->image).blocks, 0);
    }
}

TEST_F(Threaded, aDriverThatIsResetAgainAndAgainIsGivenUp) {
    std::atomic<int> called = 0;
    auto started = RenderThread::start([&called] { ++called; }, [] { return true; });
    ASSERT_TRUE(started);
    started.value()->post(request(60, 40));
    started.value()->wait();
    EXPECT_EQ(started.value()->failure().front().id, "KS0401");
    EXPECT_FALSE(started.value()->take());
    started.value()->post(request(60, 40)); // is not drawn, and nobody waits for it
    started.value()->wait();
    started.value().reset();
    EXPECT_EQ(called.load(), 1);
}

TEST_F(Threaded, endsWhileRequestsWait) {
    for (int i = 0; i < 5; ++i) {
        m_thread->post(request(400, 300));
    }
    m_thread.reset(); // must return, and not call back afterwards
    const int called = m_called;
    EXPECT_LE(called, 6);
}

} // namespace
} // namespace knittsim::render
