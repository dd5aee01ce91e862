#include "core/pattern/held_loops.h"

#include "core/pattern/move_plan.h"

#include <cstdlib>

namespace knittsim::pattern {

using machine::Bed;
using machine::Needle;

HeldLoops::HeldLoops(int wales) {
    for (std::vector<bool>& needles : m_rows) {
        needles.assign(static_cast<std::size_t>(wales), false);
    }
}

Bed HeldLoops::bedOf(int wale) const {
    return !has(Bed::Front, wale) && has(Bed::Rear, wale) ? Bed::Rear : Bed::Front;
}

void HeldLoops::set(Needle needle, bool held) {
    if (needle.index >= 0 && needle.index < static_cast<int>(row(needle.bed).size())) {
        row(needle.bed)[static_cast<std::size_t>(needle.index)] = held;
    }
}

void HeldLoops::apply(const machine::Operation& operation) {
    using machine::OperationKind;
    const auto moveOn = [&] {
        const auto at = static_cast<std::size_t>(operation.needle.index);
        const std::vector<bool>& from = row(operation.needle.bed);
        if (at < from.size() && from[at]) {
            set(operation.needle, false);
            set(operation.target, true);
        }
    };
    if (operation.kind == OperationKind::Xfer || operation.kind == OperationKind::Split) {
        moveOn();
    }
    if (machine::makesLoop(operation.kind)) {
        set(operation.needle, true);
    } else if (operation.kind == OperationKind::Drop) {
        set(operation.needle, false);
    }
}

std::uint8_t HeldLoops::bedsOf(int wale) const {
    unsigned beds = 0;
    for (std::size_t bed = 0; bed < m_rows.size(); ++bed) {
        beds |= m_rows[bed][static_cast<std::size_t>(wale)] ? 1U << bed : 0U;
    }
    return static_cast<std::uint8_t>(beds);
}

void HeldLoops::toBed(int wale, Bed bed, ProgramBuilder& builder) {
    const Bed other = bed == Bed::Front ? Bed::Rear : Bed::Front;
    if (has(other, wale)) {
        builder.rack(0);
        builder.transfer({other, wale}, {bed, wale});
        row(other)[static_cast<std::size_t>(wale)] = false;
        add({bed, wale});
    }
}

void HeldLoops::drop(Needle needle, ProgramBuilder& builder) {
    if (has(needle.bed, needle.index)) {
        builder.drop(needle);
        set(needle, false);
    }
}

void HeldLoops::bringNeighbours(const std::vector<LoopMove>& moves, const std::vector<bool>& leaves,
                                ProgramBuilder& builder) {
    for (const LoopMove& move : moves) {
        const int reach = std::abs(move.to - move.from);
        for (int wale = move.from - reach; wale <= move.from + reach; ++wale) {
            const bool inside = wale >= 0 && wale < static_cast<int>(leaves.size());
            if (reach > 2 && inside && !leaves[static_cast<std::size_t>(wale)]) {
                toBed(wale, Bed::Front, builder);
            }
        }
    }
}

void HeldLoops::move(const std::vector<LoopMove>& moves, ProgramBuilder& builder) {
    std::vector<bool> leaves(row(Bed::Front).size(), false);
    for (const LoopMove& move : moves) {
        leaves[static_cast<std::size_t>(move.from)] = true;
        toBed(move.from, Bed::Rear, builder);
    }
    for (const LoopMove& move : moves) {
        if (!leaves[static_cast<std::size_t>(move.to)]) {
            toBed(move.to, Bed::Front, builder);
        }
    }
    bringNeighbours(moves, leaves, builder);
    for (const MoveStep& step : planMoves(moves)) {
        builder.rack(step.rack);
        for (const LoopMove& move : step.moves) {
            builder.transfer({Bed::Rear, move.from}, {Bed::Front, move.to});
            row(Bed::Rear)[static_cast<std::size_t>(move.from)] = false;
            add({Bed::Front, move.to});
        }
    }
}

} // namespace knittsim::pattern
