#pragma once

#include "core/machine/emulator.h"

#include <memory>
#include <vector>

namespace knittsim::machine {

/// The machine after any operation of a program: keyframes plus replay. Immutable once made; safe to read
/// from several threads. Owns copies of the program and the profile.
class Timeline {
public:
    Timeline(Program program, MachineProfile profile);

    const Program& program() const { return m_program; }
    const MachineProfile& profile() const { return m_profile; }
    const LoopTable& loops() const { return m_loops; }
    const Diagnostics& diagnostics() const { return m_diagnostics; }
    OperationIndex operationCount() const { return static_cast<OperationIndex>(m_program.operations.size()); }

    /// The machine after the first `count` operations; 0 <= count <= operationCount().
    MachineState stateAfter(OperationIndex count) const;

    const MachineState& finalState() const { return m_keyframes.back(); }

    /// Number of stored keyframes, for tests of the memory bound.
    std::size_t keyframeCount() const { return m_keyframes.size(); }

private:
    Program m_program;
    MachineProfile m_profile;
    LoopTable m_loops;
    Diagnostics m_diagnostics;
    OperationIndex m_interval = 1;
    std::vector<MachineState> m_keyframes; ///< after 0, interval, 2 interval, ... and the last operation
};

} // namespace knittsim::machine
