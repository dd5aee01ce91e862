#pragma once

#include "core/machine/needle.h"
#include "core/pattern/chart.h"
#include "core/pattern/program_builder.h"

#include <array>
#include <vector>

namespace knittsim::pattern {

/// Which needles hold loops, and the transfers that change it. Needles are numbered as wales.
class HeldLoops {
public:
    explicit HeldLoops(int wales);

    bool has(machine::Bed bed, int wale) const { return row(bed)[static_cast<std::size_t>(wale)]; }
    bool any(int wale) const { return has(machine::Bed::Front, wale) || has(machine::Bed::Rear, wale); }
    /// Bed on which the wale's loops hang; the front bed where there are none, or on both.
    machine::Bed bedOf(int wale) const;

    void add(machine::Needle needle) { row(needle.bed)[static_cast<std::size_t>(needle.index)] = true; }
    /// What an operation of any kind does; needles outside of the wales hold nothing.
    void apply(const machine::Operation& operation);
    /// Bit 1 << Bed for each bed that holds loops of the wale.
    std::uint8_t bedsOf(int wale) const;

    /// Transfers the loops of the facing needle, if any, to this bed at racking 0.
    void toBed(int wale, machine::Bed bed, ProgramBuilder& builder);
    /// Drops the loops of the needle, if any.
    void drop(machine::Needle needle, ProgramBuilder& builder);
    /// Carries out moves: all loops to the rear bed, then racking by racking to the front. Every `from` holds
    /// a loop. Around moves over more than two needles the others wait on the front bed: behind, the racking
    /// would pull them away from the loops that have arrived.
    void move(const std::vector<LoopMove>& moves, ProgramBuilder& builder);

private:
    std::vector<bool>& row(machine::Bed bed) { return m_rows[static_cast<std::size_t>(bed)]; }
    const std::vector<bool>& row(machine::Bed bed) const { return m_rows[static_cast<std::size_t>(bed)]; }

    void set(machine::Needle needle, bool held);
    void bringNeighbours(const std::vector<LoopMove>& moves, const std::vector<bool>& leaves,
                         ProgramBuilder& builder);

    std::array<std::vector<bool>, machine::kBedCount> m_rows; ///< by Bed and wale
};

} // namespace knittsim::pattern
