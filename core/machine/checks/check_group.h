#pragma once

#include "core/machine/checks/findings.h"
#include "core/machine/timeline.h"

namespace knittsim::machine {

/// A few rules that need the same memory. It is shown the machine before and after every operation and, in
/// between, hears what happens to loops and yarns. Constant time for each event, apart from loops that move.
class CheckGroup : public EmulationListener {
public:
    CheckGroup(const Timeline& timeline, Findings& findings)
        : m_program(timeline.program()), m_profile(timeline.profile()), m_loops(timeline.loops()),
          m_findings(findings) {}

    virtual void before(const Operation&, const MachineState&) {}
    virtual void after(const Operation&, const MachineState&) {}
    virtual void atEnd(const MachineState&) {}

protected:
    const std::string& nameOf(CarrierIndex carrier) const { return m_program.header.carriers[carrier].name; }
    const Loop& loopAt(LoopIndex loop) const { return m_loops.loops[static_cast<std::size_t>(loop)]; }

    const Program& m_program;
    const MachineProfile& m_profile;
    const LoopTable& m_loops; ///< all loops the program will make
    Findings& m_findings;
};

/// "2 loops", "1 loop".
std::string loopsText(std::size_t count);

/// "1+2" of carriers 1 and 2 in this order.
std::string namesText(const Program& program, const CarrierSet& carriers);

} // namespace knittsim::machine
