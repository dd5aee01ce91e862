#pragma once

#include "core/machine/loop.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace knittsim::machine {

/// Where a loop lies on its latch needle.
enum class LoopPlace : std::uint8_t {
    Hook,        ///< in the hook
    Latch,       ///< on the open latch: it would go back into the hook
    Shaft,       ///< behind the latch: the needle is cleared
    OverLatch,   ///< outside the closed latch, on its way off the needle
    KnockedOver, ///< off the needle
};

/// A loop as one sees it. Lengths along a needle are parts of its longest stroke.
struct SeenLoop {
    LoopIndex loop = 0;
    CarrierIndex carrier = 0;
    LoopPlace place = LoopPlace::Hook;
    double slide = 0; ///< way from the hook down the shaft; 0..1
    double drawn = 1; ///< 0: the yarn just lies in the hook; 1: drawn to its full length

    bool operator==(const SeenLoop&) const = default;
};

/// A needle with its loops, the one nearest to its own bed first.
struct SeenNeedle {
    Needle needle;
    double pitches = 0; ///< position along the front bed
    double height = 0;  ///< 0: at rest .. 1: highest, giving its loops away
    double latch = 0;   ///< 0: closed .. 1: open
    std::vector<SeenLoop> loops;

    bool operator==(const SeenNeedle&) const = default;
};

/// An end of a piece of yarn: a loop, or the place of a loop that has left its needle (`loop` is -1).
struct YarnEnd {
    Needle needle;
    LoopIndex loop = -1;

    bool operator==(const YarnEnd&) const = default;
};

/// Yarn between two neighbouring loops that are both held.
struct SeenLink {
    CarrierIndex carrier = 0;
    YarnEnd from;
    YarnEnd to;

    bool operator==(const SeenLink&) const = default;
};

struct SeenCarrier {
    CarrierIndex carrier = 0;
    int rail = 0; ///< Carrier::rail
    double pitches = 0;
    bool in = false;             ///< in action; else it stands beside the fabric
    bool hooked = false;         ///< the inserting hook holds its yarn
    std::optional<YarnEnd> yarn; ///< where its yarn ends; none before its first loop

    bool operator==(const SeenCarrier&) const = default;
};

struct SeenCarriage {
    double pitches = 0;
    int direction = 0; ///< +1 to the right, -1 to the left, 0 before the first pass

    bool operator==(const SeenCarriage&) const = default;
};

/// Loops between two needles. They are on neither.
struct LoopFlight {
    Needle from;
    Needle to;
    double progress = 0; ///< 0..1
    std::vector<SeenLoop> loops;

    bool operator==(const LoopFlight&) const = default;
};

/// Part of the beds that is looked at, positions along the front bed in pitches.
struct BedWindow {
    double first = 0;
    double last = 0;
};

/// What one sees of the machine at one moment: needles within a window and what belongs to them. Carriers are
/// all that the program ever brings in, wherever they stand.
struct BedPicture {
    double rack = 0;
    std::vector<SeenNeedle> needles; ///< by bed and index; sliders only where the program uses them
    std::vector<SeenLink> links;
    std::vector<SeenCarrier> carriers;
    std::optional<LoopFlight> flight;
    std::optional<SeenCarriage> carriage; ///< none before the first operation at a needle

    bool operator==(const BedPicture&) const = default;
};

} // namespace knittsim::machine
