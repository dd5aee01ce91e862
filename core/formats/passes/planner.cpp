#include "core/formats/passes/planner.h"

#include "core/formats/passes/settings.h"
#include "core/formats/passes/yarn_mover.h"
#include "core/machine/emulator.h"

#include <algorithm>
#include <cmath>

namespace knittsim::formats::passes {

using machine::CarrierIndex;
using machine::CarrierSet;
using machine::Direction;
using machine::Needle;
using machine::Operation;
using machine::OperationKind;

namespace {

/// What no machine can do: the first error that the emulator finds.
std::optional<Diagnostic> firstFault(const machine::Program& program) {
    const machine::MachineProfile profile = machine::genericProfile();
    machine::Emulator emulator(program, profile);
    Diagnostics found;
    while (!emulator.atEnd()) {
        emulator.step(nullptr, &found);
        for (Diagnostic& diagnostic : found) {
            if (diagnostic.severity == Severity::Error) {
                return std::move(diagnostic);
            }
        }
        found.clear();
    }
    return std::nullopt;
}

class Planner {
public:
    Planner(const machine::Program& program, const PassRules& rules)
        : m_program(program), m_rules(rules), m_settings(rules),
          m_mover(rules, program.header.carriers.size()) {}

    Result<std::vector<Pass>> run();

private:
    bool plan(const Operation& op);
    bool stitch(const Operation& op);
    bool transfer(const Operation& op);
    bool giveBack(const Operation& op);
    bool bringIn(const Operation& op);
    bool takeOut(const Operation& op);
    bool releaseHook();
    bool rackTo(double rack);
    bool comeIn(const CarrierSet& carriers, Pass& pass);
    Pass passOf(const Operation& op) const;
    bool setting(bool good, const char* why);
    bool refuse(std::string why);

    const machine::Program& m_program;
    const PassRules& m_rules;
    Settings m_settings;
    YarnMover m_mover;
    const Operation* m_op = nullptr;
    std::optional<Diagnostic> m_error;
    std::vector<Needle> m_onSliders;          ///< split there and not given back yet
    std::optional<Direction> m_hookDirection; ///< in which the hook's yarn came in
    CarrierSet m_hook;
};

Result<std::vector<Pass>> Planner::run() {
    if (auto fault = firstFault(m_program)) {
        return std::move(*fault);
    }
    for (const Operation& op : m_program.operations) {
        m_op = &op;
        if (!plan(op)) {
            return std::move(*m_error);
        }
    }
    if (!m_onSliders.empty() && !refuse("loops split to sliders are not given back")) {
        return std::move(*m_error);
    }
    for (std::size_t c = 0; c < m_program.header.carriers.size(); ++c) {
        if (m_mover.isIn(static_cast<CarrierIndex>(c))) {
            const int line = m_op != nullptr ? m_op->line : -1;
            return Diagnostic{"KS0210",
                              Severity::Error,
                              Place{.file = m_program.file, .line = line},
                              {m_program.header.carriers[c].name}};
        }
    }
    return std::move(m_mover).takePasses();
}

bool Planner::plan(const Operation& op) {
    const bool harmless = op.kind == OperationKind::Rack || op.kind == OperationKind::Split ||
                          op.kind == OperationKind::Xfer || op.kind == OperationKind::Colour;
    if (!m_onSliders.empty() && !harmless) {
        return refuse("loops split to sliders have to be given back first");
    }
    switch (op.kind) {
    case OperationKind::In:
    case OperationKind::InHook:
        return bringIn(op);
    case OperationKind::ReleaseHook:
        return releaseHook();
    case OperationKind::Out:
    case OperationKind::OutHook:
        return takeOut(op);
    case OperationKind::StitchSize:
        return refuse("leading and tension name no entry of a stitch table; use x-stitch-number");
    case OperationKind::StitchNumber:
        return setting(m_settings.setStitch(op.value), "the machine has no such stitch number");
    case OperationKind::Rack:
        return rackTo(op.value);
    case OperationKind::Knit:
    case OperationKind::Tuck:
    case OperationKind::Miss:
    case OperationKind::Drop:
    case OperationKind::Amiss:
        return stitch(op);
    case OperationKind::Split:
    case OperationKind::Xfer:
        return transfer(op);
    case OperationKind::Pause:
        m_mover.pause(op.text < 0 ? std::string() : m_program.texts[static_cast<std::size_t>(op.text)]);
        return true;
    case OperationKind::Extension:
        if (m_settings.isEndPass(m_program.texts[static_cast<std::size_t>(op.text)])) {
            m_mover.endPass();
            return true;
        }
        return setting(m_settings.read(m_program.texts[static_cast<std::size_t>(op.text)]),
                       "its value is none that the machine has");
    case OperationKind::YarnIn:
    case OperationKind::YarnOut:
        return refuse("yarns have to come in and go out by carriers");
    case OperationKind::Colour:
        break;
    }
    return true;
}

bool Planner::setting(bool good, const char* why) {
    return good || refuse(why);
}

bool Planner::rackTo(double rack) {
    const double whole = std::floor(rack);
    const double fraction = rack - whole;
    // A quarter and a half pitch both mean that the needles interleave.
    const bool interleaved = fraction == m_rules.interleavedFraction || fraction == 0.25;
    if ((fraction != 0 && !interleaved) || std::abs(rack) > m_rules.maxRack) {
        return refuse("the machine has no such racking");
    }
    m_mover.setRack(whole + (fraction != 0 ? m_rules.interleavedFraction : 0));
    return true;
}

bool Planner::bringIn(const Operation& op) {
    if (op.kind == OperationKind::InHook && !m_rules.hook) {
        return refuse("the machine has no yarn inserting hook; use 'in' and 'out'");
    }
    if (op.carriers.size() > m_rules.maxCarriersInSet) {
        return refuse("so many carriers cannot work together");
    }
    m_mover.bringIn(op.carriers, op.kind);
    return true;
}

/// The carriers that come in with this pass, if they are waiting to.
bool Planner::comeIn(const CarrierSet& carriers, Pass& pass) {
    const auto arrival = m_mover.takeArrival(carriers);
    if (!arrival) {
        return true;
    }
    if (!(arrival->carriers == carriers)) {
        return refuse("carriers that come in together have to make their first stitch together");
    }
    pass.gripper = Gripper::In;
    if (arrival->hook) {
        pass.hook = Hook::In;
        m_hook = carriers;
        m_hookDirection = pass.direction;
    }
    return true;
}

bool Planner::releaseHook() {
    if (!m_hookDirection) {
        return refuse("the yarn in the hook has made no stitch");
    }
    m_mover.releaseHook(m_hook, *m_hookDirection, m_settings.pass());
    m_hookDirection.reset();
    m_hook = {};
    return true;
}

bool Planner::takeOut(const Operation& op) {
    if (op.kind == OperationKind::OutHook && !m_rules.hook) {
        return refuse("the machine has no yarn inserting hook; use 'in' and 'out'");
    }
    for (const CarrierIndex c : op.carriers) {
        if (!m_mover.place(c)) {
            return refuse("a carrier goes out that has made no stitch");
        }
        if (m_hook.contains(c)) {
            return refuse("the hook still holds the yarn");
        }
    }
    if (op.carriers.size() > m_rules.maxCarriersInSet) {
        return refuse("so many carriers cannot work together");
    }
    if (op.carriers.empty()) {
        return true;
    }
    m_mover.takeOut(op.carriers, op.kind == OperationKind::OutHook, m_settings.pass());
    m_settings.passMade();
    return true;
}

Pass Planner::passOf(const Operation& op) const {
    Pass pass = m_settings.pass();
    pass.rack = m_mover.rack();
    pass.carriers = op.carriers;
    if (!op.carriers.empty()) {
        pass.direction = op.direction;
    }
    return pass;
}

bool Planner::stitch(const Operation& op) {
    if (op.carriers.size() > m_rules.maxCarriersInSet) {
        return refuse("so many carriers cannot work together");
    }
    if (op.kind == OperationKind::Miss && op.carriers.empty()) {
        return true;
    }
    Pass pass = passOf(op);
    const bool front = isFront(op.needle.bed);
    Work work = op.kind == OperationKind::Knit || op.kind == OperationKind::Drop ? Work::Knit : Work::Tuck;
    if (op.kind == OperationKind::Miss) {
        work = m_rules.missesAreSoft ? Work::None : Work::Miss;
    } else {
        m_mover.clear(op.needle, op.carriers, m_settings.pass());
        if (!m_rules.oneStitchNumber) {
            Sizes& sizes = pass.sizes[m_mover.slot(op.needle)];
            (front ? sizes.front : sizes.rear) = m_settings.stitch();
        }
    }
    if (op.kind == OperationKind::Amiss && m_rules.tucksWithKnits) {
        pass.kind = PassKind::Amiss;
    }
    if (!m_rules.tucksWithKnits && work != Work::Miss) {
        (front ? pass.frontWork : pass.rearWork) = work;
    }
    pass.presser = m_settings.presser();
    pass.roller = m_settings.roller();
    pass.cells[m_mover.slot(op.needle)] = front ? Cell{work, Work::None} : Cell{Work::None, work};
    if (!comeIn(op.carriers, pass)) {
        return false;
    }
    m_settings.passMade();
    m_mover.add(std::move(pass));
    m_mover.stitched(op.carriers, op.needle, op.direction);
    return true;
}

/// A transfer back from the sliders after a split to them belongs to the pass of the split.
bool Planner::giveBack(const Operation& op) {
    const auto found = std::find(m_onSliders.begin(), m_onSliders.end(), op.needle);
    if (found == m_onSliders.end()) {
        return refuse("loops split to sliders have to be given back first");
    }
    if (!m_mover.returnSliders()) {
        return refuse("loops split to sliders in one pass are given back at one racking 1, 2 or 4 away");
    }
    m_onSliders.erase(found);
    return true;
}

bool Planner::transfer(const Operation& op) {
    const bool split = op.kind == OperationKind::Split;
    const bool fromSlider = isSlider(op.needle.bed);
    const bool toSlider = isSlider(op.target.bed);
    if ((fromSlider || toSlider) && !m_rules.sliders) {
        return refuse("the machine has no sliders");
    }
    if (fromSlider && toSlider) {
        return refuse("a loop cannot go from slider to slider");
    }
    if (op.carriers.size() > m_rules.maxCarriersInSet) {
        return refuse("so many carriers cannot work together");
    }
    if (!m_onSliders.empty() && fromSlider) {
        return giveBack(op);
    }
    if (!m_onSliders.empty() && !(split && toSlider)) {
        return refuse("loops split to sliders have to be given back first");
    }
    Pass pass = passOf(op);
    const bool front = isFront(op.needle.bed);
    const Work work = split ? Work::Split : Work::Transfer;
    if (split && m_rules.splitsWithKnits) {
        (front ? pass.frontWork : pass.rearWork) = work;
    } else if (split) {
        pass.kind = toSlider ? PassKind::SliderSplit : PassKind::Split;
    } else {
        pass.kind = fromSlider ? PassKind::FromSliders : toSlider ? PassKind::ToSliders : PassKind::Transfer;
        pass.stitch = m_settings.transferStitch();
        pass.fourPasses = m_settings.fourPasses();
    }
    m_mover.clear(op.needle, op.carriers, m_settings.pass());
    pass.roller = m_settings.addedRoller();
    const int slot = m_mover.slot(op.needle);
    pass.cells[slot] = front ? Cell{work, Work::None} : Cell{Work::None, work};
    if (!m_rules.oneStitchNumber) {
        const int number = split ? m_settings.stitch() : m_settings.transferStitch();
        pass.sizes[slot] = {number, number};
    }
    if (!comeIn(op.carriers, pass)) {
        return false;
    }
    if (pass.kind != PassKind::Stitch && pass.gripper != Gripper::None) {
        return refuse("a yarn cannot come in with a split");
    }
    if (split && toSlider) {
        m_onSliders.push_back(op.target);
    }
    m_settings.passMade();
    m_mover.add(std::move(pass));
    m_mover.moved(op.needle, op.target);
    m_mover.stitched(op.carriers, op.needle, op.direction);
    return true;
}

bool Planner::refuse(std::string why) {
    std::string what = machine::toString(m_op->kind);
    if (m_op->kind == OperationKind::Extension) {
        what = m_program.texts[static_cast<std::size_t>(m_op->text)];
    }
    Place place{.file = m_program.file, .line = m_op->line};
    place.operation = static_cast<int>(m_op - m_program.operations.data());
    m_error =
        Diagnostic{m_rules.refusal, Severity::Error, std::move(place), {std::move(what), std::move(why)}};
    return false;
}

} // namespace

Result<std::vector<Pass>> planPasses(const machine::Program& program, const PassRules& rules) {
    return Planner(program, rules).run();
}

} // namespace knittsim::formats::passes
