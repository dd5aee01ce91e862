#include "core/machine/checks/check.h"

#include "core/machine/checks/groups.h"

#include <algorithm>
#include <cstdlib>

namespace knittsim::machine {

namespace {

/// Tells several listeners of everything.
class Everyone : public EmulationListener {
public:
    explicit Everyone(const std::vector<std::unique_ptr<CheckGroup>>& groups) : m_groups(groups) {}

    void yarnMoved(CarrierIndex carrier, const CarrierPlace* from, const CarrierPlace& to) override {
        tell([&](CheckGroup& group) { group.yarnMoved(carrier, from, to); });
    }
    void loopMade(LoopIndex loop) override {
        tell([&](CheckGroup& group) { group.loopMade(loop); });
    }
    void loopsMoved(Needle from, Needle to, std::span<const LoopIndex> loops) override {
        tell([&](CheckGroup& group) { group.loopsMoved(from, to, loops); });
    }
    void loopsDropped(Needle needle, std::span<const LoopIndex> loops) override {
        tell([&](CheckGroup& group) { group.loopsDropped(needle, loops); });
    }
    void racked(double from, double to) override {
        tell([&](CheckGroup& group) { group.racked(from, to); });
    }
    void yarnCut(CarrierIndex carrier) override {
        tell([&](CheckGroup& group) { group.yarnCut(carrier); });
    }

private:
    template<class Message> void tell(Message message) {
        for (const auto& group : m_groups) {
            message(*group);
        }
    }

    const std::vector<std::unique_ptr<CheckGroup>>& m_groups;
};

std::vector<std::unique_ptr<CheckGroup>> makeGroups(const Timeline& timeline, Findings& findings) {
    std::vector<std::unique_ptr<CheckGroup>> groups;
    for (const auto make : {makeHookCheck, makeNeedleCheck, makeCarrierCheck, makeSetCheck, makeLoopCheck,
                            makeHeldCheck, makeFloatCheck, makeStretchCheck}) {
        groups.push_back(make(timeline, findings));
    }
    return groups;
}

/// The emulator does not carry out what lies too far off (KS0208); nothing more is to be said about it.
bool isRefused(const Operation& op) {
    return std::abs(op.needle.index) > kMaxNeedleIndex || std::abs(op.target.index) > kMaxNeedleIndex;
}

} // namespace

std::string loopsText(std::size_t count) {
    return std::to_string(count) + (count == 1 ? " loop" : " loops");
}

std::string namesText(const Program& program, const CarrierSet& carriers) {
    std::string text;
    for (const CarrierIndex c : carriers) {
        text += (text.empty() ? "" : "+") + program.header.carriers[c].name;
    }
    return text;
}

Diagnostics check(const Timeline& timeline) {
    const Program& program = timeline.program();
    Findings findings(program);
    const auto groups = makeGroups(timeline, findings);
    Everyone everyone(groups);
    Emulator emulator(program, timeline.profile(), timeline.stateAfter(0));
    while (!emulator.atEnd()) {
        const OperationIndex index = emulator.state().nextOperation;
        const Operation& op = program.operations[static_cast<std::size_t>(index)];
        findings.setOperation(index);
        if (isRefused(op)) {
            emulator.step();
            continue;
        }
        for (const auto& group : groups) {
            group->before(op, emulator.state());
        }
        emulator.step(&everyone);
        for (const auto& group : groups) {
            group->after(op, emulator.state());
        }
    }
    for (const auto& group : groups) {
        group->atEnd(emulator.state());
    }
    Diagnostics all = timeline.diagnostics();
    const Diagnostics more = findings.take();
    all.insert(all.end(), more.begin(), more.end());
    sortByOperation(all);
    return all;
}

} // namespace knittsim::machine
