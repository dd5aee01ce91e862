#pragma once

#include "core/base/diagnostic.h"
#include "core/machine/profile.h"
#include "core/machine/program.h"
#include "core/machine/state.h"

#include <span>
#include <utility>
#include <vector>

namespace knittsim::machine {

/// What one operation did to loops and yarns, in the order it happened. Spans are valid during the call only.
class EmulationListener {
public:
    virtual ~EmulationListener() = default;

    /// A carrier's yarn moves from one place to another, before it makes a loop or after a miss.
    /// `from` is null when the yarn has just come in.
    virtual void yarnMoved(CarrierIndex, const CarrierPlace* /*from*/, const CarrierPlace& /*to*/) {}

    /// A loop is made; its parents leave the needle (Knit), stay (Tuck) or move on (Split, told by
    /// loopsMoved).
    virtual void loopMade(LoopIndex) {}

    /// All loops of a needle move to another needle, on top of the loops there: the last of `loops` first.
    virtual void loopsMoved(Needle /*from*/, Needle /*to*/, std::span<const LoopIndex> /*loops*/) {}

    /// Loops fall off a needle with nothing through them.
    virtual void loopsDropped(Needle, std::span<const LoopIndex>) {}

    /// The rear bed moves. Called before the state changes.
    virtual void racked(double /*from*/, double /*to*/) {}

    /// A carrier leaves the action.
    virtual void yarnCut(CarrierIndex) {}
};

/// Carries out operations with the meaning of knitout 2: knit through all loops of a needle, tuck, split,
/// transfer to empty and occupied needles, carriers that move along with transferred loops.
///
/// An operation that a machine cannot do is reported (KS02xx) and carried out as far as it makes sense, so
/// that a program with faults still shows. Only an impossible transfer leaves its loops where they are.
class Emulator {
public:
    /// Starts with empty beds. Both must outlive the emulator.
    Emulator(const Program& program, const MachineProfile& profile);

    /// Replays from a state of the same program; the loops are known already, so loops() stays empty.
    Emulator(const Program& program, const MachineProfile& profile, MachineState state);

    const MachineState& state() const { return m_state; }
    MachineState takeState() { return std::move(m_state); }
    const LoopTable& loops() const { return m_loops; }
    LoopTable takeLoops() { return std::move(m_loops); }
    bool atEnd() const;

    /// Carries out the next operation. Both may be null.
    void step(EmulationListener* listener = nullptr, Diagnostics* diagnostics = nullptr);

private:
    class Report;

    void bringIn(const Operation& op, const Report& report);
    void takeOut(const Operation& op, const Report& report, EmulationListener* listener);
    void placeYarns(const Operation& op, const Report& report, EmulationListener* listener);
    void knit(Operation op, const Report& report, EmulationListener* listener);
    void transfer(const Operation& op, const Report& report, EmulationListener* listener);
    void drop(Needle needle, EmulationListener* listener);
    void useCarriers(const CarrierSet& carriers, const Report& report);
    void moveYarn(CarrierIndex carrier, const CarrierPlace& to, EmulationListener* listener);
    void hangLoops(const Operation& op, EmulationListener* listener);
    void moveLoops(Needle from, Needle to, const CarrierSet& staying, EmulationListener* listener);
    bool canTransfer(const Operation& op, const Report& report) const;
    bool inRange(const Operation& op, const Report& report);
    void startYarn(CarrierIndex carrier);
    std::vector<LoopIndex>& loopsOn(Needle needle);
    CarrierState& carrier(CarrierIndex index) { return m_state.carriers[index]; }

    const Program& m_program;
    const MachineProfile& m_profile;
    MachineState m_state;
    LoopTable m_loops;
    bool m_replay = false;
    std::vector<LoopIndex> m_parents; ///< loops the present operation draws through
};

/// Needles farther than this from needle 0 are refused (KS0208), so that memory stays bounded. Real beds have
/// fewer than 1,500 needles.
constexpr std::int32_t kMaxNeedleIndex = 4000;

} // namespace knittsim::machine
