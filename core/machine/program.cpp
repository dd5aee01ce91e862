#include "core/machine/program.h"

#include <algorithm>

namespace knittsim::machine {

std::optional<CarrierIndex> Program::findCarrier(const std::string& name) const {
    const auto found = std::find_if(header.carriers.begin(), header.carriers.end(),
                                    [&](const Carrier& carrier) { return carrier.name == name; });
    if (found == header.carriers.end()) {
        return std::nullopt;
    }
    return static_cast<CarrierIndex>(found - header.carriers.begin());
}

/// Needles of both beds that face each other may be named in either order, pitches.
constexpr double kFacing = 0.5;

std::vector<Pass> findPasses(const Program& program) {
    std::vector<Pass> passes;
    double rack = 0;
    bool open = false;
    double last = 0;
    Needle lastNeedle;
    for (std::size_t i = 0; i < program.operations.size(); ++i) {
        const Operation& op = program.operations[i];
        if (op.kind == OperationKind::Rack) {
            rack = op.value;
        }
        const bool yarn = carriesYarn(op.kind) && !op.carriers.empty();
        if (!yarn) {
            const bool harmless = op.kind == OperationKind::Extension || op.kind == OperationKind::Colour ||
                                  op.kind == OperationKind::StitchNumber ||
                                  op.kind == OperationKind::StitchSize ||
                                  op.kind == OperationKind::ReleaseHook || op.kind == OperationKind::Pause;
            open = open && harmless;
            continue;
        }
        const double at = positionPitches(op.needle, rack);
        const bool joins = open && passes.back().direction == op.direction &&
                           passes.back().carriers == op.carriers && op.needle != lastNeedle &&
                           (at - last) * sign(op.direction) >= -kFacing;
        if (!joins) {
            passes.push_back({static_cast<OperationIndex>(i), 0, op.direction, op.carriers});
            open = true;
        }
        passes.back().count = static_cast<OperationIndex>(i) - passes.back().first + 1;
        last = at;
        lastNeedle = op.needle;
    }
    return passes;
}

} // namespace knittsim::machine
