#pragma once

#include "core/fabric/fabric.h"
#include "core/machine/timeline.h"

#include <cstdint>
#include <vector>

namespace knittsim::fabric {

/// One thing that happened to a loop or at a bonding point.
struct HistoryEvent {
    enum class Kind : std::uint8_t {
        Made,    ///< hung on `needle`; `others`: the loops it was drawn through
        Moved,   ///< from `needle` to `target`; `others`: the loops that hung there already
        Crossed, ///< another strand was passed; `others`: the loop whose leg or float that is
        Bound,   ///< `others` came through it on `needle`
        Dropped, ///< let go by `needle` with nothing through it
        Held,    ///< hangs on `needle` at the end
    };

    Kind kind = Kind::Made;
    OperationIndex operation = -1; ///< -1 for Held
    std::int32_t line = -1;        ///< 1-based line of the source, -1 where there is none
    Needle needle{};
    Needle target{}; ///< Moved only
    double rack = 0; ///< after the operation, pitches
    std::vector<LoopIndex> others{};

    bool operator==(const HistoryEvent&) const = default;
};

/// Everything that is known of one bonding point (Meissner & Eberhardt 1998, section 3).
struct PointHistory {
    PointIndex point = -1;
    LoopIndex loop = -1; ///< as in BondingPoint
    Role role = Role::Head;
    Side side = Side::Left;
    Piece piece = Piece::LeftLeg; ///< Crossing: on which it lies
    CarrierIndex carrier = 0;
    std::int32_t course = 0; ///< fabric course of the loop
    /// The loop whose yarn lies in front here (towards a viewer of the front bed), -1 where there is one yarn
    /// only. Where a loop is drawn through others: in front at the old heads; at the old legs, below, it is
    /// the other way round.
    LoopIndex inFront = -1;
    Piece partnerPiece = Piece::LeftLeg; ///< Crossing: on which the other strand passes
    std::vector<HistoryEvent> events;    ///< in the order of time
};

/// What happened to one loop in the first `count` operations (all when negative): made, every transfer,
/// bound, dropped or held. Replays the machine from the making of the loop until it leaves the needles;
/// nothing of it is stored. Empty when the loop is not made by then.
std::vector<HistoryEvent> loopHistory(const machine::Timeline& timeline, LoopIndex loop,
                                      OperationIndex count = -1);

/// The history of a point of `fabric`, which is built from the first `count` operations of `timeline` (all
/// when negative), reduced or not: that of its loop and, for a crossing, the passing itself.
PointHistory pointHistory(const Fabric& fabric, const machine::Timeline& timeline, PointIndex point,
                          OperationIndex count = -1);

} // namespace knittsim::fabric
