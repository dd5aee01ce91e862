#pragma once

#include "core/simulation/simulation.h"

#include <functional>
#include <memory>
#include <vector>

namespace knittsim::simulation {

/// Rare news that must not be lost, unlike frames.
struct Event {
    enum class Kind : std::uint8_t { Loaded, Started, Paused, AtRest, Failed, IntegratorChanged } kind;
    std::uint64_t generation = 0;
    StopReason reason = StopReason::None;
    std::string note;
};

/// Owns one Simulation on a thread of its own for its whole life. All functions may be called from one other thread
/// and return at once.
class Worker {
public:
    /// `wake` is called on the worker's thread whenever a new frame or event waits; it must be quick and thread-safe.
    explicit Worker(std::function<void()> wake);
    ~Worker();   ///< stops within 50 ms and joins
    Worker(const Worker&) = delete;
    Worker& operator=(const Worker&) = delete;

    void post(Command command);

    /// The latest frame if it is newer than the one taken last, else null. Frames are never queued.
    std::shared_ptr<const Frame> takeFrame();

    /// Events since the last call, oldest first.
    std::vector<Event> takeEvents();

private:
    struct Implementation;
    std::unique_ptr<Implementation> m;
};

} // namespace knittsim::simulation
