#include "core/machine/needle_stroke.h"

#include <algorithm>

namespace knittsim::machine {

namespace {

constexpr double kHookDepth = 0.08;  ///< a loop that slid less is still in the hook
constexpr double kOpensWithin = 0.3; ///< of the slide, while a loop turns the latch back

double between(double t, double rises, double risen, double sinks, double sunk) {
    return glide(t, rises, risen) - glide(t, sinks, sunk);
}

LoopPlace placeOf(double slide, bool sinking) {
    if (slide >= kLatchLength) {
        return LoopPlace::Shaft;
    }
    if (sinking) {
        return LoopPlace::OverLatch;
    }
    return slide < kHookDepth ? LoopPlace::Hook : LoopPlace::Latch;
}

/// The loop opens the latch on the way up and shuts it from behind on the way down.
NeedlePose clearingPose(double height, double slide, bool sinking) {
    const double latch = std::min(1.0, height / (sinking ? kLatchLength : kOpensWithin));
    return {height, latch, slide, placeOf(slide, sinking)};
}

NeedlePose shortPose(double height) {
    return {height, std::min(1.0, height / kOpensWithin), height, placeOf(height, false)};
}

} // namespace

double ramp(double t, double from, double to) {
    return std::clamp((t - from) / (to - from), 0.0, 1.0);
}

double glide(double t, double from, double to) {
    const double r = ramp(t, from, to);
    return r * r * (3 - 2 * r);
}

NeedlePose poseAt(Stroke stroke, double t) {
    using namespace phase;
    switch (stroke) {
    case Stroke::Rest:
        break;
    case Stroke::Knit: {
        const double height = kClearHeight * between(t, kArrived, kRisen, kSinks, kKnockOver);
        NeedlePose pose = clearingPose(height, height, t >= kSinks);
        if (t >= kKnockOver) {
            pose.place = LoopPlace::KnockedOver;
        }
        return pose;
    }
    case Stroke::Tuck:
        return shortPose(kTuckHeight * between(t, kArrived, kRisen, kSinks, kKnockOver));
    case Stroke::Give: {
        const double height = between(t, kArrived, kRisen, kHandOver, kReceiverSinks);
        return clearingPose(height, std::min(height, kSeat), t >= kHandOver);
    }
    case Stroke::Take:
        return shortPose(kTuckHeight * between(t, kRisen, kHandOver, kReceiverSinks, 1));
    }
    return {};
}

} // namespace knittsim::machine
