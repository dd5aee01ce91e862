#pragma once

#include "core/machine/loop.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace knittsim::machine {

/// Where a carrier stands: infinitesimally to one side of a needle.
struct CarrierPlace {
    Needle needle;
    Direction side = Direction::Right; ///< Right: just right of the needle
    double pitches = 0;                ///< position along the front bed when it got there

    bool operator==(const CarrierPlace&) const = default;
};

struct CarrierState {
    bool in = false;          ///< in action
    bool placed = false;      ///< has made a stitch or a miss since it came in
    CarrierPlace place;       ///< valid when placed
    bool looped = false;      ///< has made a loop since it came in
    Bed loopBed = Bed::Front; ///< where that loop was made
    double wayPitches = 0;    ///< way since that loop, there and back added up
    std::int32_t yarn = -1;   ///< running number of its yarn, -1 before the first
    double fedMm = 0;         ///< yarn fed of this yarn so far

    bool operator==(const CarrierState&) const = default;
};

/// Loops on the needles of one bed. Needles outside the stored range are empty.
class NeedleRow {
public:
    /// Loops on a needle in the order in which they lie on it: the first one nearest to the bed, the last one
    /// nearest to the other bed. That is the order in which they came there, but a stack that is transferred
    /// keeps its order in space and so lies the other way round on its new needle.
    std::span<const LoopIndex> at(std::int32_t index) const {
        const std::int64_t i = std::int64_t{index} - m_first;
        if (i < 0 || i >= static_cast<std::int64_t>(m_needles.size())) {
            return {};
        }
        return m_needles[static_cast<std::size_t>(i)];
    }

    std::vector<LoopIndex>& edit(std::int32_t index);

    std::int32_t first() const { return m_first; }
    std::int32_t end() const { return m_first + static_cast<std::int32_t>(m_needles.size()); }

    /// Same loops on the same needles, whatever range is stored.
    bool operator==(const NeedleRow& other) const;

private:
    std::int32_t m_first = 0;
    std::vector<std::vector<LoopIndex>> m_needles;
};

/// The machine between two operations.
struct MachineState {
    OperationIndex nextOperation = 0;      ///< operations [0, nextOperation) have been carried out
    std::array<NeedleRow, kBedCount> beds; ///< by Bed
    std::vector<CarrierState> carriers;    ///< by CarrierIndex
    CarrierSet hook;                       ///< carriers held by the yarn inserting hook
    double rack = 0;                       ///< pitches
    double loopLengthMm = 0;               ///< yarn of the next plain loop
    std::int32_t loopCount = 0;
    std::int32_t yarnCount = 0;

    std::span<const LoopIndex> loopsOn(Needle needle) const {
        return beds[static_cast<std::size_t>(needle.bed)].at(needle.index);
    }

    bool operator==(const MachineState&) const = default;
};

/// 64-bit digest of a state; equal states have equal digests.
std::uint64_t digest(const MachineState& state);

} // namespace knittsim::machine
