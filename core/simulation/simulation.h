#pragma once

#include "core/fabric/fabric.h"
#include "core/simulation/frame.h"
#include "core/yarn/yarn.h"

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace knittsim::simulation {

/// Commands are plain values; they may be made on any thread.
namespace command {

/// Takes a new fabric. Starts from the machine's positions unless `positions` (3 per entry, mm) are given.
struct Load {
    std::shared_ptr<const fabric::Fabric> fabric;
    std::vector<yarn::Yarn> yarns; ///< by carrier
    std::vector<float> positions{};
    std::uint64_t generation = 0; ///< given to the frames that follow; must rise
};
/// Goes on with another fabric, for example with a ladder taken out: state, steps and time run on; one at
/// rest moves again. Positions as for Load. Like Load when there is nothing to go on from.
struct Replace {
    std::shared_ptr<const fabric::Fabric> fabric;
    std::vector<float> positions{};
    std::uint64_t generation = 0; ///< given to the frames that follow; must rise
};
struct Start {};
struct Pause {};
struct Step {};  ///< one integrator step (by the next advance), then paused
struct Restart { ///< back to the machine's positions
    std::uint64_t generation = 0;
};
struct Stop {}; ///< pause and forget velocity
struct SetIntegrator {
    std::string id; ///< one of integrators()
};
struct SetYarn { ///< goes on from the current shape
    int carrier = 0;
    yarn::Yarn yarn;
};
struct SetResidual {
    double limit = 1e-3;
};
/// Pulls an entry towards a point with a spring until Release.
struct Drag {
    fabric::EntryIndex entry = 0;
    double x = 0, y = 0, z = 0; ///< mm
};
struct Release {};
struct Pin { ///< holds an entry where it is, or frees it
    fabric::EntryIndex entry = 0;
    bool pinned = true;
};

} // namespace command

using Command = std::variant<command::Load, command::Replace, command::Start, command::Pause, command::Step,
                             command::Restart, command::Stop, command::SetIntegrator, command::SetYarn,
                             command::SetResidual, command::Drag, command::Release, command::Pin>;

/// What can settle the fabric. The first one is the default.
struct IntegratorInfo {
    const char* id;      ///< "newton-cg", "cash-karp", ...
    const char* name;    ///< English name; the window translates it
    const char* purpose; ///< one English sentence
};
std::span<const IntegratorInfo> integrators();

/// The simulation without a thread: the command line and the tests use it as it is, the window through
/// Worker. Gives the same numbers for the same commands. Nothing is thrown.
class Simulation {
public:
    Simulation();
    ~Simulation();
    Simulation(Simulation&&) noexcept;
    Simulation& operator=(Simulation&&) noexcept;

    void apply(const Command& command);

    /// Runs for about `milliseconds` when running; at least one step unless cancelled. `cancelled` may be
    /// null and is asked at least every 20 ms of work. Returns true when the shape or the state changed.
    bool advance(double milliseconds, const std::function<bool()>* cancelled = nullptr);

    /// Takes steps until the simulation stops by itself, or the limit is reached.
    void runToEnd(double maxSeconds);

    State state() const;

    /// What there is to tell without the cost of a frame.
    struct Status {
        std::uint64_t generation = 0;
        StopReason reason = StopReason::None;
        std::string note;
    };
    Status status() const;

    /// True when one step of the present integrator changes the picture visibly, so that a viewer wants each
    /// one.
    bool takesLargeSteps() const;

    /// The present picture.
    Frame frame() const;

private:
    struct Implementation;
    std::unique_ptr<Implementation> m;
};

} // namespace knittsim::simulation
