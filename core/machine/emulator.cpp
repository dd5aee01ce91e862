#include "core/machine/emulator.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace knittsim::machine {

/// Where the findings of one operation go.
class Emulator::Report {
public:
    Report(const Program& program, OperationIndex index, Diagnostics* diagnostics)
        : m_program(program), m_index(index), m_diagnostics(diagnostics) {}

    void operator()(const char* id, Severity severity, std::vector<std::string> arguments) const {
        if (m_diagnostics == nullptr) {
            return;
        }
        const Operation& op = m_program.operations[static_cast<std::size_t>(m_index)];
        Place place{.file = m_program.file, .line = op.line, .operation = m_index};
        if (makesLoop(op.kind) || op.kind == OperationKind::Xfer) {
            place.needle = toString(op.needle);
        }
        m_diagnostics->push_back({id, severity, std::move(place), std::move(arguments)});
    }

    const std::string& name(CarrierIndex carrier) const { return m_program.header.carriers[carrier].name; }
    OperationIndex index() const { return m_index; }

private:
    const Program& m_program;
    OperationIndex m_index;
    Diagnostics* m_diagnostics;
};

Emulator::Emulator(const Program& program, const MachineProfile& profile)
    : m_program(program), m_profile(profile) {
    m_state.carriers.resize(program.header.carriers.size());
    m_state.loopLengthMm = profile.defaultLoopLengthMm;
}

Emulator::Emulator(const Program& program, const MachineProfile& profile, MachineState state)
    : m_program(program), m_profile(profile), m_state(std::move(state)), m_replay(true) {}

bool Emulator::atEnd() const {
    return m_state.nextOperation >= static_cast<OperationIndex>(m_program.operations.size());
}

void Emulator::step(EmulationListener* listener, Diagnostics* diagnostics) {
    const OperationIndex index = m_state.nextOperation;
    const Operation& op = m_program.operations[static_cast<std::size_t>(index)];
    const Report report(m_program, index, diagnostics);
    m_state.nextOperation = index + 1;
    if (!inRange(op, report)) {
        return;
    }
    switch (op.kind) {
    case OperationKind::In:
    case OperationKind::InHook:
        bringIn(op, report);
        break;
    case OperationKind::ReleaseHook:
        if (!(m_state.hook == op.carriers)) {
            report("KS0205", Severity::Error, {op.carriers.empty() ? "?" : report.name(op.carriers[0])});
        }
        m_state.hook = {};
        break;
    case OperationKind::Out:
    case OperationKind::OutHook:
    case OperationKind::YarnOut:
        takeOut(op, report, listener);
        break;
    case OperationKind::StitchSize:
    case OperationKind::StitchNumber:
        m_state.loopLengthMm = m_profile.loopLengthMm(op.value);
        break;
    case OperationKind::Rack:
        if (listener != nullptr) {
            listener->racked(m_state.rack, op.value);
        }
        m_state.rack = op.value;
        break;
    case OperationKind::Knit:
    case OperationKind::Tuck:
    case OperationKind::Split:
        knit(op, report, listener);
        break;
    case OperationKind::Drop:
        drop(op.needle, listener);
        break;
    case OperationKind::Xfer:
        transfer(op, report, listener);
        break;
    case OperationKind::Miss:
        useCarriers(op.carriers, report);
        for (const CarrierIndex c : op.carriers) {
            moveYarn(c, {op.needle, op.direction, positionPitches(op.needle, m_state.rack)}, listener);
        }
        break;
    case OperationKind::YarnIn:
        placeYarns(op, report, listener);
        break;
    case OperationKind::Amiss:
    case OperationKind::Pause:
    case OperationKind::Colour:
    case OperationKind::Extension:
        break;
    }
}

void Emulator::startYarn(CarrierIndex index) {
    CarrierState& state = carrier(index);
    state = {};
    state.in = true;
    state.yarn = m_state.yarnCount++;
}

void Emulator::bringIn(const Operation& op, const Report& report) {
    for (const CarrierIndex c : op.carriers) {
        if (carrier(c).in) {
            report("KS0202", Severity::Error, {report.name(c)});
        } else {
            startYarn(c);
        }
    }
    if (op.kind == OperationKind::InHook) {
        if (!m_state.hook.empty()) {
            report("KS0204", Severity::Error, {});
        }
        m_state.hook = op.carriers;
    }
}

void Emulator::takeOut(const Operation& op, const Report& report, EmulationListener* listener) {
    if (op.kind == OperationKind::OutHook && !m_state.hook.empty()) {
        report("KS0204", Severity::Error, {});
    }
    for (const CarrierIndex c : op.carriers) {
        if (!carrier(c).in) {
            report("KS0203", Severity::Error, {report.name(c)});
            continue;
        }
        if (listener != nullptr) {
            listener->yarnCut(c);
        }
        const std::int32_t yarn = carrier(c).yarn;
        carrier(c) = {};
        carrier(c).yarn = yarn;
    }
}

void Emulator::placeYarns(const Operation& op, const Report& report, EmulationListener* listener) {
    for (const CarrierIndex c : op.carriers) {
        if (carrier(c).in) {
            report("KS0202", Severity::Error, {report.name(c)});
            if (listener != nullptr) {
                listener->yarnCut(c);
            }
        }
        startYarn(c);
        moveYarn(c, {op.needle, op.direction, positionPitches(op.needle, m_state.rack)}, listener);
    }
}

void Emulator::useCarriers(const CarrierSet& carriers, const Report& report) {
    for (const CarrierIndex c : carriers) {
        if (!carrier(c).in) {
            // Reported once: the carrier counts as brought in from here on.
            report("KS0201", Severity::Error, {report.name(c)});
            startYarn(c);
        }
    }
}

void Emulator::moveYarn(CarrierIndex index, const CarrierPlace& to, EmulationListener* listener) {
    CarrierState& state = carrier(index);
    if (state.looped) {
        state.wayPitches += std::abs(to.pitches - state.place.pitches);
    }
    if (listener != nullptr) {
        listener->yarnMoved(index, state.placed ? &state.place : nullptr, to);
    }
    state.place = to;
    state.placed = true;
}

std::vector<LoopIndex>& Emulator::loopsOn(Needle needle) {
    return m_state.beds[static_cast<std::size_t>(needle.bed)].edit(needle.index);
}

void Emulator::knit(Operation op, const Report& report, EmulationListener* listener) {
    if (isSlider(op.needle.bed)) {
        const Bed hooks = isFront(op.needle.bed) ? Bed::Front : Bed::Rear;
        report("KS0209", Severity::Error, {toString(op.needle), toString(Needle{hooks, op.needle.index})});
        op.needle.bed = hooks;
    }
    useCarriers(op.carriers, report);
    const double at = positionPitches(op.needle, m_state.rack);
    for (const CarrierIndex c : op.carriers) {
        moveYarn(c, {op.needle, opposite(op.direction), at}, listener);
    }
    m_parents.clear();
    if (op.kind != OperationKind::Tuck) {
        std::vector<LoopIndex>& old = loopsOn(op.needle);
        m_parents.assign(old.begin(), old.end());
        if (op.kind == OperationKind::Split && canTransfer(op, report)) {
            moveLoops(op.needle, op.target, op.carriers, listener);
        } else {
            old.clear();
        }
    }
    hangLoops(op, listener);
}

void Emulator::hangLoops(const Operation& op, EmulationListener* listener) {
    std::vector<LoopIndex>& needle = loopsOn(op.needle);
    const double at = positionPitches(op.needle, m_state.rack);
    const auto firstParent = static_cast<std::int32_t>(m_loops.parents.size());
    if (!m_replay) {
        m_loops.parents.insert(m_loops.parents.end(), m_parents.begin(), m_parents.end());
    }
    for (const CarrierIndex c : op.carriers) {
        CarrierState& state = carrier(c);
        const double extra =
            state.looped
                ? m_profile.extraYarnMm(state.wayPitches, isFront(state.loopBed) != isFront(op.needle.bed))
                : 0;
        state.fedMm += extra;
        const double begin = state.fedMm;
        state.fedMm += m_state.loopLengthMm;
        if (!m_replay) {
            m_loops.loops.push_back({.operation = m_state.nextOperation - 1,
                                     .carrier = c,
                                     .kind = op.kind,
                                     .direction = op.direction,
                                     .needle = op.needle,
                                     .rack = m_state.rack,
                                     .lengthMm = m_state.loopLengthMm,
                                     .wayPitches = state.wayPitches,
                                     .floatMm = extra,
                                     .yarnBeginMm = begin,
                                     .yarnEndMm = state.fedMm,
                                     .firstParent = firstParent,
                                     .parentCount = static_cast<std::int32_t>(m_parents.size()),
                                     .yarn = state.yarn});
        }
        const LoopIndex loop = m_state.loopCount++;
        needle.push_back(loop);
        if (listener != nullptr) {
            listener->loopMade(loop);
        }
        state.place = {op.needle, op.direction, at};
        state.looped = true;
        state.loopBed = op.needle.bed;
        state.wayPitches = 0;
    }
}

void Emulator::drop(Needle needle, EmulationListener* listener) {
    std::vector<LoopIndex>& loops = loopsOn(needle);
    if (listener != nullptr && !loops.empty()) {
        listener->loopsDropped(needle, loops);
    }
    loops.clear();
}

void Emulator::transfer(const Operation& op, const Report& report, EmulationListener* listener) {
    if (canTransfer(op, report)) {
        moveLoops(op.needle, op.target, {}, listener);
    }
}

bool Emulator::canTransfer(const Operation& op, const Report& report) const {
    if (isFront(op.needle.bed) == isFront(op.target.bed)) {
        report("KS0207", Severity::Error, {toString(op.needle), toString(op.target)});
        return false;
    }
    const Needle front = isFront(op.needle.bed) ? op.needle : op.target;
    const Needle rear = isFront(op.needle.bed) ? op.target : op.needle;
    const int wanted = front.index - rear.index;
    if (m_state.rack != wanted) {
        report("KS0206", Severity::Error,
               {toString(op.needle), toString(op.target), fmt::format("{}", m_state.rack),
                std::to_string(wanted)});
        return false;
    }
    return true;
}

void Emulator::moveLoops(Needle from, Needle to, const CarrierSet& staying, EmulationListener* listener) {
    // Both rows are made large enough first, so that the references stay valid.
    loopsOn(from);
    std::vector<LoopIndex>& target = loopsOn(to);
    std::vector<LoopIndex>& source = loopsOn(from);
    if (listener != nullptr && !source.empty()) {
        listener->loopsMoved(from, to, source);
    }
    // The loop nearest to its own bed is farthest from the other one.
    target.insert(target.end(), source.rbegin(), source.rend());
    source.clear();
    for (std::size_t c = 0; c < m_state.carriers.size(); ++c) {
        CarrierState& state = m_state.carriers[c];
        if (state.placed && state.place.needle == from && !staying.contains(static_cast<CarrierIndex>(c))) {
            state.place.needle = to;
        }
    }
}

bool Emulator::inRange(const Operation& op, const Report& report) {
    const auto check = [&](Needle needle) {
        if (std::abs(needle.index) <= kMaxNeedleIndex) {
            return true;
        }
        report("KS0208", Severity::Error, {toString(needle), std::to_string(kMaxNeedleIndex)});
        return false;
    };
    switch (op.kind) {
    case OperationKind::Split:
    case OperationKind::Xfer:
        return check(op.needle) && check(op.target);
    case OperationKind::Knit:
    case OperationKind::Tuck:
    case OperationKind::Drop:
    case OperationKind::Miss:
    case OperationKind::YarnIn:
        return check(op.needle);
    default:
        return true;
    }
}

} // namespace knittsim::machine
