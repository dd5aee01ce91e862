#include "core/simulation/worker.h"
#include "swatches.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <condition_variable>
#include <mutex>

namespace knittsim::simulation {
namespace {

using test::load;
using test::plain;

/// A worker with somebody who waits for its news.
class Viewer {
public:
    Viewer() : m_worker([this] { wake(); }) {}

    Worker& worker() { return m_worker; }

    /// Waits until an event of this kind has come. False after a minute, which no test should need.
    bool waitFor(Event::Kind kind) {
        std::unique_lock lock(m_mutex);
        return m_news.wait_for(lock, std::chrono::minutes(1), [&] {
            collect();
            return std::any_of(m_events.begin() + static_cast<std::ptrdiff_t>(m_seen), m_events.end(),
                               [&](const Event& e) {
                                   ++m_seen;
                                   return e.kind == kind;
                               });
        });
    }

    /// Waits for a frame for which `wanted` holds; every frame on the way is checked against the newest
    /// generation.
    template<class Wanted> std::shared_ptr<const Frame> waitForFrame(Wanted wanted) {
        std::unique_lock lock(m_mutex);
        m_news.wait_for(lock, std::chrono::minutes(1), [&] {
            collect();
            return m_frame && wanted(*m_frame);
        });
        return m_frame;
    }

    const std::vector<Event>& events() const { return m_events; }
    bool generationsRose() const { return m_rising; }

private:
    void wake() {
        const std::lock_guard lock(m_mutex);
        m_news.notify_all();
    }

    void collect() {
        if (auto frame = m_worker.takeFrame()) {
            m_rising = m_rising && (!m_frame || frame->generation >= m_frame->generation);
            m_frame = std::move(frame);
        }
        // After the frame: what a frame shows has been told before.
        for (Event& e : m_worker.takeEvents()) {
            m_events.push_back(std::move(e));
        }
    }

    std::mutex m_mutex;
    std::condition_variable m_news;
    std::vector<Event> m_events;
    std::size_t m_seen = 0;
    std::shared_ptr<const Frame> m_frame;
    bool m_rising = true;
    Worker m_worker; // last: its thread calls wake() from the first moment on
};

TEST(Worker, SettlesLikeTheSimulationWithoutAThread) {
    const auto fabric = plain();
    Simulation simulation;
    simulation.apply(load(fabric));
    simulation.runToEnd(60);
    Viewer viewer;
    viewer.worker().post(load(fabric));
    viewer.worker().post(command::Start{});
    ASSERT_TRUE(viewer.waitFor(Event::Kind::AtRest));
    const auto frame = viewer.waitForFrame([](const Frame& f) { return f.state == State::AtRest; });
    ASSERT_TRUE(frame);
    EXPECT_EQ(frame->positions, simulation.frame().positions);
    EXPECT_EQ(frame->tension, simulation.frame().tension);
    EXPECT_EQ(frame->step, simulation.frame().step);
}

TEST(Worker, TellsEveryChangeOnceAndInOrder) {
    Viewer viewer;
    viewer.worker().post(load(plain(5, 5), 3));
    viewer.worker().post(command::SetIntegrator{"fire"});
    viewer.worker().post(command::Start{});
    ASSERT_TRUE(viewer.waitFor(Event::Kind::AtRest));
    std::vector<Event::Kind> kinds;
    for (const Event& e : viewer.events()) {
        kinds.push_back(e.kind);
        EXPECT_EQ(e.generation, 3U);
    }
    EXPECT_THAT(kinds, ::testing::ElementsAre(Event::Kind::Loaded, Event::Kind::IntegratorChanged,
                                              Event::Kind::Started, Event::Kind::AtRest));
    EXPECT_EQ(viewer.events().back().reason, StopReason::ResidualReached);
}

TEST(Worker, AFrameIsTakenOnce) {
    Viewer viewer;
    viewer.worker().post(load(plain(3, 3)));
    ASSERT_TRUE(viewer.waitForFrame([](const Frame& f) { return f.state == State::Ready; }));
    EXPECT_EQ(viewer.worker().takeFrame(), nullptr);
}

TEST(Worker, TwoHundredLoadsAndRestartsNeverShowAnOldGeneration) {
    Viewer viewer;
    const auto small = plain(4, 4);
    const auto large = plain(14, 14);
    const std::vector<const char*> ids{"newton-cg", "fire", "cvode-bdf", "cash-karp", "kinsol"};
    std::uint64_t generation = 0;
    for (int i = 0; i < 200; ++i) {
        ++generation;
        const auto& fabric = i % 2 == 0 ? small : large;
        if (i % 3 == 2) {
            viewer.worker().post(command::Restart{generation});
        } else {
            viewer.worker().post(load(fabric, generation));
        }
        viewer.worker().post(command::SetIntegrator{ids[static_cast<std::size_t>(i) % ids.size()]});
        viewer.worker().post(command::Start{});
        if (i % 10 == 0) {
            const std::uint64_t now = generation;
            ASSERT_TRUE(
                viewer.waitForFrame([&](const Frame& f) { return f.generation >= now && f.step > 0; }));
        }
    }
    const auto frame = viewer.waitForFrame([&](const Frame& f) { return f.generation == generation; });
    ASSERT_TRUE(frame);
    EXPECT_EQ(frame->generation, generation);
    EXPECT_TRUE(viewer.generationsRose());
    int loads = 0;
    viewer.worker().post(command::Pause{});
    for (const Event& e : viewer.events()) {
        loads += e.kind == Event::Kind::Loaded ? 1 : 0;
    }
    EXPECT_EQ(loads, 200);
}

TEST(Worker, PauseIsHeardInsideALongStep) {
    // One step here takes far longer than the pause may: the step under way is given up, not finished.
    Viewer viewer;
    viewer.worker().post(load(plain(150, 150)));
    viewer.worker().post(command::Start{});
    ASSERT_TRUE(viewer.waitFor(Event::Kind::Started));
    viewer.worker().post(command::Pause{});
    ASSERT_TRUE(viewer.waitFor(Event::Kind::Paused));
    EXPECT_EQ(viewer.events().back().reason, StopReason::Paused);
}

TEST(Worker, IsGoneWhileItRuns) {
    for (const IntegratorInfo& info : integrators()) {
        Viewer viewer;
        viewer.worker().post(load(plain(30, 30)));
        viewer.worker().post(command::SetIntegrator{info.id});
        viewer.worker().post(command::Start{});
        ASSERT_TRUE(viewer.waitFor(Event::Kind::Started));
    }
}

TEST(Worker, AWakeThatThrowsNothingIsNotNeeded) {
    Worker worker(nullptr);
    worker.post(load(plain(3, 3)));
    worker.post(command::Start{});
}

} // namespace
} // namespace knittsim::simulation
