#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace knittsim::simulation {

enum class State : std::uint8_t { Empty, Ready, Running, Paused, AtRest, Failed };

/// Why the simulation is not running. The window turns it into a sentence.
enum class StopReason : std::uint8_t {
    None,
    ResidualReached,    ///< relative residual below the limit
    Stagnation,         ///< energy and shape no longer change
    StepLimit,
    Diverged,           ///< numbers became useless; the last good shape is kept
    SolverFailed,       ///< the integrator gave up; see Frame::note
    Paused,
    Stopped,
};

/// Energies in uJ.
struct Energies {
    double kinetic = 0;     ///< E_kin, equation 4
    double potential = 0;   ///< V, equation 3
    double lagrangian() const { return kinetic - potential; }   ///< L, equation 5
};

/// One picture of the running simulation. Immutable once published.
struct Frame {
    std::uint64_t generation = 0;     ///< rises with each load and restart
    std::int64_t step = 0;            ///< integrator steps since then
    std::vector<float> positions;     ///< 3 per entry of the bonding point table, mm
    std::vector<float> tension;       ///< by bonding point: force in the yarn to the next point, mN (+ pull)
    Energies energies;
    double residual = 1;              ///< norm of the force relative to the start
    double stepSize = 0;              ///< s, or 0 for solvers without time
    double time = 0;                  ///< simulated s
    double millisecondsPerStep = 0;
    State state = State::Empty;
    StopReason reason = StopReason::None;
    std::string integrator;           ///< id of the integrator that made it
    std::string note;                 ///< technical detail of a failure, not translated
};

} // namespace knittsim::simulation
