#include "tests/support/rewrite_program.h"

#include "core/machine/timeline.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>

namespace knittsim::test {

using machine::Bed;
using machine::Direction;
using machine::MachineState;
using machine::Needle;
using machine::Operation;
using machine::OperationIndex;
using machine::OperationKind;
using machine::Program;

Bed otherBed(Bed bed) {
    switch (bed) {
    case Bed::Front:
        return Bed::Rear;
    case Bed::Rear:
        return Bed::Front;
    case Bed::FrontSlider:
        return Bed::RearSlider;
    case Bed::RearSlider:
        break;
    }
    return Bed::FrontSlider;
}

namespace {

using Operations = std::vector<Operation>;

/// Not std::uniform_int_distribution, whose results differ between libraries.
int below(std::mt19937& random, int count) {
    return static_cast<int>(random() % static_cast<std::uint32_t>(count));
}

struct Stretch {
    double low;
    double high;
};

std::optional<Stretch> stretchOf(const Operation& op, const MachineState& state) {
    if (!carriesYarn(op.kind) && op.kind != OperationKind::Xfer && op.kind != OperationKind::Drop) {
        return std::nullopt;
    }
    const double at = machine::positionPitches(op.needle, state.rack);
    Stretch stretch{at, at};
    for (const machine::CarrierIndex carrier : op.carriers) {
        const machine::CarrierState& stands = state.carriers[carrier];
        if (!stands.in) {
            return std::nullopt;
        }
        if (stands.placed) {
            stretch.low = std::min(stretch.low, stands.place.pitches);
            stretch.high = std::max(stretch.high, stands.place.pitches);
        }
    }
    return stretch;
}

bool areIndependent(const Operation& a, const Operation& b, const MachineState& before) {
    const auto shared = [&](machine::CarrierIndex carrier) { return b.carriers.contains(carrier); };
    const auto one = stretchOf(a, before);
    const auto two = stretchOf(b, before);
    return one && two && std::ranges::none_of(a.carriers, shared) &&
           (one->high < two->low || two->high < one->low);
}

bool isWhole(double rack) {
    return rack == std::floor(rack);
}

Operation rackTo(double rack) {
    Operation op;
    op.kind = OperationKind::Rack;
    op.value = rack;
    return op;
}

Operation xfer(Needle from, Needle to) {
    Operation op;
    op.kind = OperationKind::Xfer;
    op.needle = from;
    op.target = to;
    return op;
}

Operation missTo(Needle needle, Direction side, machine::CarrierIndex carrier) {
    Operation op;
    op.kind = OperationKind::Miss;
    op.needle = needle;
    op.direction = side;
    op.carriers.push(carrier);
    return op;
}

Needle facing(Needle needle, std::int32_t rack) {
    return {otherBed(needle.bed), machine::isFront(needle.bed) ? needle.index - rack : needle.index + rack};
}

Operations rackThereAndBack(const MachineState& state, std::mt19937& random) {
    const double rack = below(random, 13) / 2.0 - 3;
    return rack == state.rack ? Operations{} : Operations{rackTo(rack), rackTo(state.rack)};
}

Operations transferThereAndBack(const MachineState& state, std::mt19937& random) {
    const Bed bed = below(random, 2) == 0 ? Bed::Front : Bed::Rear;
    const machine::NeedleRow& row = state.beds[static_cast<std::size_t>(bed)];
    if (!isWhole(state.rack) || row.first() >= row.end()) {
        return {};
    }
    const auto rack = static_cast<std::int32_t>(state.rack);
    const Needle from{bed, row.first() + below(random, row.end() - row.first())};
    const Needle to = facing(from, rack);
    if (state.loopsOn(from).empty() || !state.loopsOn(to).empty()) {
        return {};
    }
    return {xfer(from, to), xfer(to, from)};
}

/// The place must not have moved with the rear bed since the carrier came there.
Operations missThereAndBack(const MachineState& state, std::mt19937& random) {
    const auto index = static_cast<std::size_t>(below(random, static_cast<int>(state.carriers.size())));
    const machine::CarrierState& carrier = state.carriers[index];
    const machine::CarrierPlace& place = carrier.place;
    const auto standsThere = [&](const machine::CarrierState& c) {
        return c.placed && c.place.pitches == place.pitches && c.place.side == place.side;
    };
    if (!carrier.in || !carrier.placed || std::ranges::count_if(state.carriers, standsThere) != 1 ||
        machine::positionPitches(place.needle, state.rack) != place.pitches) {
        return {};
    }
    const Needle far{Bed::Front, place.needle.index + below(random, 13) - 6};
    const auto c = static_cast<machine::CarrierIndex>(index);
    return {missTo(far, below(random, 2) == 0 ? Direction::Left : Direction::Right, c),
            missTo(place.needle, place.side, c)};
}

Operations dropOfNothing(const MachineState& state, std::mt19937& random) {
    Operation op;
    op.kind = OperationKind::Drop;
    op.needle = {below(random, 2) == 0 ? Bed::Front : Bed::Rear, below(random, 16) - 6};
    return state.loopsOn(op.needle).empty() ? Operations{op} : Operations{};
}

Operations operationsOf(Nothing nothing, const MachineState& state, const Operation& next,
                        std::mt19937& random) {
    switch (nothing) {
    case Nothing::RackThereAndBack:
        return rackThereAndBack(state, random);
    case Nothing::RackInSteps:
        return next.kind == OperationKind::Rack ? Operations{rackTo(below(random, 13) / 2.0 - 3)}
                                                : Operations{};
    case Nothing::TransferThereAndBack:
        return transferThereAndBack(state, random);
    case Nothing::TransferBeforeItsOpposite:
        return next.kind == OperationKind::Xfer ? Operations{xfer(next.target, next.needle)} : Operations{};
    case Nothing::MissThereAndBack:
        return missThereAndBack(state, random);
    case Nothing::DropOfNothing:
        return dropOfNothing(state, random);
    }
    return {};
}

} // namespace

Program mirrored(Program program) {
    for (Operation& op : program.operations) {
        op.direction = opposite(op.direction);
        op.needle.index = -op.needle.index;
        op.target.index = -op.target.index;
        if (op.kind == OperationKind::Rack) {
            op.value = -op.value;
        }
    }
    return program;
}

Program turnedOver(Program program) {
    int lastRail = 0;
    for (const machine::Carrier& carrier : program.header.carriers) {
        lastRail = std::max(lastRail, carrier.rail);
    }
    for (machine::Carrier& carrier : program.header.carriers) {
        carrier.rail = lastRail - carrier.rail;
    }
    for (Operation& op : program.operations) {
        op.direction = opposite(op.direction);
        op.needle = {otherBed(op.needle.bed), -op.needle.index};
        op.target = {otherBed(op.target.bed), -op.target.index};
    }
    return program;
}

Program withCarriersAsideAtRacks(Program program) {
    constexpr std::int32_t kFar = 200; ///< and each carrier so much farther that it never passes another one
    constexpr std::int32_t kApart = 20;
    const machine::Timeline timeline(program, machine::genericProfile());
    Operations operations;
    for (std::size_t at = 0; at < program.operations.size(); ++at) {
        if (program.operations[at].kind == OperationKind::Rack) {
            const MachineState state = timeline.stateAfter(static_cast<OperationIndex>(at));
            for (std::size_t c = 0; c < state.carriers.size(); ++c) {
                if (state.carriers[c].in) {
                    const Direction side = c % 2 == 0 ? Direction::Left : Direction::Right;
                    const std::int32_t far = kFar + kApart * static_cast<std::int32_t>(c);
                    operations.push_back(missTo({Bed::Front, machine::sign(side) * far}, side,
                                                static_cast<machine::CarrierIndex>(c)));
                }
            }
        }
        operations.push_back(program.operations[at]);
    }
    program.operations = std::move(operations);
    return program;
}

Program withSwaps(Program program, int tries, std::uint32_t seed) {
    std::mt19937 random(seed);
    const machine::MachineProfile profile = machine::genericProfile();
    for (int i = 0; i < tries; ++i) {
        const int at = below(random, std::max(1, static_cast<int>(program.operations.size()) - 1));
        machine::Emulator emulator(program, profile);
        while (emulator.state().nextOperation < at && !emulator.atEnd()) {
            emulator.step();
        }
        const auto first = program.operations.begin() + at;
        if (program.operations.end() - first > 1 && areIndependent(first[0], first[1], emulator.state())) {
            std::iter_swap(first, first + 1);
        }
    }
    return program;
}

Program with(Nothing nothing, Program program, std::uint32_t seed) {
    std::mt19937 random(seed);
    const machine::Timeline timeline(program, machine::genericProfile());
    for (int tries = 0; tries < 50 && !program.operations.empty(); ++tries) {
        const OperationIndex at = below(random, timeline.operationCount());
        const Operation& next = program.operations[static_cast<std::size_t>(at)];
        const Operations more = operationsOf(nothing, timeline.stateAfter(at), next, random);
        if (!more.empty()) {
            program.operations.insert(program.operations.begin() + at, more.begin(), more.end());
            break;
        }
    }
    return program;
}

Program withTuckFromTheOtherBed(Program program, std::uint32_t seed) {
    std::mt19937 random(seed);
    const machine::Timeline timeline(program, machine::genericProfile());
    for (int tries = 0; tries < 50 && !program.operations.empty(); ++tries) {
        const OperationIndex at = below(random, timeline.operationCount());
        const auto tuck = program.operations.begin() + at;
        const MachineState state = timeline.stateAfter(at);
        const Needle from = facing(tuck->needle, static_cast<std::int32_t>(state.rack));
        if (tuck->kind == OperationKind::Tuck && tuck->carriers.size() == 1 && isWhole(state.rack) &&
            state.loopsOn(from).empty()) {
            const Operation back = xfer(from, tuck->needle);
            tuck->needle = from;
            program.operations.insert(tuck + 1, back);
            break;
        }
    }
    return program;
}

} // namespace knittsim::test
