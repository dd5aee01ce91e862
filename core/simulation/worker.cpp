#include "core/simulation/worker.h"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <thread>
#include <utility>

namespace knittsim::simulation {

namespace {

using Clock = std::chrono::steady_clock;
constexpr std::chrono::milliseconds kFrameInterval{16};

/// Commands that make the step under way useless. The others wait for its end, else a stream of them
/// (a person dragging) would never let a step be finished.
bool interrupts(const Command& command) {
    return std::holds_alternative<command::Load>(command) ||
           std::holds_alternative<command::Replace>(command) ||
           std::holds_alternative<command::Pause>(command) ||
           std::holds_alternative<command::Restart>(command) ||
           std::holds_alternative<command::Stop>(command) ||
           std::holds_alternative<command::SetIntegrator>(command);
}

} // namespace

struct Worker::Implementation {
    explicit Implementation(std::function<void()> wakeViewer)
        : wake(std::move(wakeViewer)), thread([this] { work(); }) {}

    ~Implementation() {
        {
            const std::lock_guard lock(mutex);
            quit = true;
        }
        interrupted = true;
        arrived.notify_one();
        thread.join();
    }

    Implementation(const Implementation&) = delete;
    Implementation& operator=(const Implementation&) = delete;

    void post(Command command) {
        {
            const std::lock_guard lock(mutex);
            if (interrupts(command)) {
                interrupted = true;
            }
            const bool newerDrag = !commands.empty() && std::holds_alternative<command::Drag>(command) &&
                                   std::holds_alternative<command::Drag>(commands.back());
            if (newerDrag) {
                commands.back() = std::move(command);
            } else {
                commands.push_back(std::move(command));
            }
        }
        arrived.notify_one();
    }

    // The rest runs on the worker's thread.

    void work() {
        Simulation simulation;
        const std::function<bool()> cancelled = [this] { return interrupted.load(); };
        Clock::time_point nextFrame = Clock::now();
        while (waitForWork(simulation.state() == State::Running)) {
            const bool commanded = obey(simulation);
            const State before = simulation.state();
            // Large steps are shown one by one, small ones as many as fit between two frames.
            const bool moved =
                simulation.advance(simulation.takesLargeSteps() ? 0 : kFrameInterval.count(), &cancelled);
            tellChange(before, simulation);
            if (commanded || moved) {
                publish(simulation);
            }
            if (simulation.state() == State::Running && simulation.takesLargeSteps()) {
                pace(nextFrame);
            }
        }
    }

    /// False when it is time to quit.
    bool waitForWork(bool running) {
        std::unique_lock lock(mutex);
        if (!running) {
            arrived.wait(lock, [this] { return quit || !commands.empty(); });
        }
        return !quit;
    }

    /// Carries out all waiting commands. True when there was one.
    bool obey(Simulation& simulation) {
        std::deque<Command> taken;
        {
            const std::lock_guard lock(mutex);
            taken.swap(commands);
            interrupted = quit;
        }
        for (const Command& command : taken) {
            const State before = simulation.state();
            simulation.apply(command);
            tellCommand(command, before, simulation);
        }
        return !taken.empty();
    }

    void tellCommand(const Command& command, State before, const Simulation& simulation) {
        if (std::holds_alternative<command::Load>(command) ||
            std::holds_alternative<command::Replace>(command) ||
            std::holds_alternative<command::Restart>(command)) {
            add(Event::Kind::Loaded, simulation);
        } else if (std::holds_alternative<command::SetIntegrator>(command)) {
            add(Event::Kind::IntegratorChanged, simulation);
        }
        tellChange(before, simulation);
    }

    void tellChange(State before, const Simulation& simulation) {
        const State now = simulation.state();
        if (now == before) {
            return;
        }
        switch (now) {
        case State::Running:
            return add(Event::Kind::Started, simulation);
        case State::Paused:
            return add(Event::Kind::Paused, simulation);
        case State::AtRest:
            return add(Event::Kind::AtRest, simulation);
        case State::Failed:
            return add(Event::Kind::Failed, simulation);
        case State::Empty:
        case State::Ready:
            return;
        }
    }

    void add(Event::Kind kind, const Simulation& simulation) {
        const Simulation::Status status = simulation.status();
        const std::lock_guard lock(mutex);
        events.push_back({kind, status.generation, status.reason, status.note});
    }

    void publish(const Simulation& simulation) {
        auto frame = std::make_shared<const Frame>(simulation.frame());
        {
            const std::lock_guard lock(mutex);
            latest = std::move(frame);
        }
        if (wake) {
            wake();
        }
    }

    /// Large steps: waits until the next frame is due; commands end the wait.
    void pace(Clock::time_point& nextFrame) {
        std::unique_lock lock(mutex);
        arrived.wait_until(lock, nextFrame, [this] { return quit || !commands.empty(); });
        nextFrame = Clock::now() + kFrameInterval;
    }

    std::function<void()> wake;
    std::mutex mutex;
    std::condition_variable arrived;
    std::deque<Command> commands;          // guarded by mutex
    std::vector<Event> events;             // guarded by mutex
    std::shared_ptr<const Frame> latest;   // guarded by mutex; null when taken
    bool quit = false;                     // guarded by mutex
    std::atomic<bool> interrupted = false; // set with mutex held while commands change
    std::thread thread;                    // last: starts when all else is made
};

Worker::Worker(std::function<void()> wake) : m(std::make_unique<Implementation>(std::move(wake))) {}
Worker::~Worker() = default;

void Worker::post(Command command) {
    m->post(std::move(command));
}

std::shared_ptr<const Frame> Worker::takeFrame() {
    const std::lock_guard lock(m->mutex);
    return std::exchange(m->latest, nullptr);
}

std::vector<Event> Worker::takeEvents() {
    const std::lock_guard lock(m->mutex);
    return std::exchange(m->events, {});
}

} // namespace knittsim::simulation
