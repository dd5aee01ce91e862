#pragma once

#include "core/machine/bed_picture.h"

namespace knittsim::machine {

/// Moments of an operation, as parts of its duration. The rise of a needle, the yarn, and the fall follow
/// each other as they do below the cams of a carriage.
namespace phase {
constexpr double kArrived = 0.15;   ///< the carriage is at the needle, which begins to rise
constexpr double kRisen = 0.4;      ///< the needle is up, the yarn comes
constexpr double kLaid = 0.475;     ///< the yarn lies in the hook: the new loop is there
constexpr double kSinks = 0.55;     ///< the carrier is past, the needle begins to sink
constexpr double kKnockOver = 0.9;  ///< the old loop slips off the needle
constexpr double kGone = 0.97;      ///< and hangs in the new one
constexpr double kHandOver = 0.6;   ///< the receiving needle is inside the loop, the giving one sinks
constexpr double kHandedOver = 0.8; ///< the loop lies in the other hook
constexpr double kReceiverSinks = 0.85;
} // namespace phase

/// How far needles rise, as parts of the longest stroke.
constexpr double kTuckHeight = 0.4;
constexpr double kLatchLength = 0.5; ///< a loop that slid farther is behind the latch
constexpr double kClearHeight = 0.75;
constexpr double kSeat = 0.6; ///< a needle that gives loops away carries them up from here on

enum class Stroke : std::uint8_t {
    Rest,
    Knit, ///< clears, takes the yarn, knocks over; also Drop, which takes none
    Tuck, ///< stops before the loop is behind the latch
    Give, ///< Xfer and Split: lifts its loops for the other needle
    Take, ///< enters the loop from the other side
};

/// A needle in the course of its stroke.
struct NeedlePose {
    double height = 0;
    double latch = 0;
    double slide = 0; ///< of the loops that were on it before
    LoopPlace place = LoopPlace::Hook;
};

/// `t` in [0, 1]; at both ends the needle is at rest.
NeedlePose poseAt(Stroke stroke, double t);

/// 0 before `from`, 1 after `to`, linear between.
double ramp(double t, double from, double to);

/// The same with a gentle start and end.
double glide(double t, double from, double to);

} // namespace knittsim::machine
