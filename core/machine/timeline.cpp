#include "core/machine/timeline.h"

#include <algorithm>

namespace knittsim::machine {

namespace {

constexpr OperationIndex kMinInterval = 256;  // replay of so many operations takes well under a millisecond
constexpr OperationIndex kMaxKeyframes = 128; // bounds the memory for long programs
constexpr std::size_t kMaxFindings = 1000;

void reportEnd(const Program& program, const MachineState& state, Diagnostics& diagnostics) {
    for (std::size_t c = 0; c < state.carriers.size(); ++c) {
        if (state.carriers[c].in) {
            Place place{.file = program.file};
            if (!program.operations.empty()) {
                place.line = program.operations.back().line;
                place.operation = static_cast<int>(program.operations.size()) - 1;
            }
            diagnostics.push_back({"KS0210", Severity::Warning, place, {program.header.carriers[c].name}});
        }
    }
}

} // namespace

Timeline::Timeline(Program program, MachineProfile profile)
    : m_program(std::move(program)), m_profile(std::move(profile)),
      m_interval(std::max(kMinInterval, operationCount() / kMaxKeyframes + 1)) {
    Emulator emulator(m_program, m_profile);
    m_keyframes.push_back(emulator.state());
    bool full = false;
    while (!emulator.atEnd()) {
        emulator.step(nullptr, full ? nullptr : &m_diagnostics);
        if (!full && m_diagnostics.size() >= kMaxFindings) {
            full = true;
            m_diagnostics.push_back(
                {"KS0211", Severity::Warning, Place{.file = m_program.file}, {std::to_string(kMaxFindings)}});
        }
        if (emulator.state().nextOperation % m_interval == 0 && !emulator.atEnd()) {
            m_keyframes.push_back(emulator.state());
        }
    }
    if (operationCount() > 0) {
        m_keyframes.push_back(emulator.takeState());
    }
    m_loops = emulator.takeLoops();
    reportEnd(m_program, m_keyframes.back(), m_diagnostics);
}

MachineState Timeline::stateAfter(OperationIndex count) const {
    const OperationIndex wanted = std::clamp(count, 0, operationCount());
    if (wanted == operationCount()) {
        return m_keyframes.back();
    }
    Emulator emulator(m_program, m_profile, m_keyframes[static_cast<std::size_t>(wanted / m_interval)]);
    while (emulator.state().nextOperation < wanted) {
        emulator.step();
    }
    return emulator.takeState();
}

} // namespace knittsim::machine
