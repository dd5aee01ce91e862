#include "ui/views/needle_beds/bed_layout.h"
#include "ui/views/needle_beds/operation_clock.h"
#include "ui/views/needle_beds/phase_text.h"

#include <gtest/gtest.h>

namespace knittsim::ui {
namespace {

OperationClock at(int step) {
    OperationClock clock;
    clock.showStep(step, 0);
    return clock;
}

TEST(OperationClock, AStepForwardRunsThroughItsOperation) {
    OperationClock clock = at(5);
    EXPECT_EQ(clock.operation(), 4);
    EXPECT_EQ(clock.phase(), 1);
    clock.showStep(6, 1000);
    EXPECT_EQ(clock.operation(), 5);
    EXPECT_EQ(clock.phase(), 0);
    clock.advance(250);
    EXPECT_DOUBLE_EQ(clock.phase(), 0.25);
    clock.advance(10'000);
    EXPECT_EQ(clock.phase(), 1);
    EXPECT_FALSE(clock.moving());
}

TEST(OperationClock, AStepBackRunsTheSameOperationBackwards) {
    OperationClock clock = at(6);
    clock.showStep(5, 1000);
    EXPECT_EQ(clock.operation(), 5);
    EXPECT_EQ(clock.phase(), 1);
    clock.advance(250);
    EXPECT_DOUBLE_EQ(clock.phase(), 0.75);
    clock.advance(1000);
    EXPECT_EQ(clock.operation(), 4) << "at rest the operation done last is shown";
    EXPECT_EQ(clock.phase(), 1);
}

TEST(OperationClock, AStepBackHalfwayTurnsRound) {
    OperationClock clock = at(5);
    clock.showStep(6, 1000);
    clock.advance(400);
    clock.showStep(5, 1000);
    EXPECT_EQ(clock.operation(), 5);
    EXPECT_DOUBLE_EQ(clock.phase(), 0.4);
    clock.advance(100);
    EXPECT_DOUBLE_EQ(clock.phase(), 0.3);
}

TEST(OperationClock, HeldItStandsAnywhereAndTheNextStepGoesOn) {
    OperationClock clock = at(5);
    clock.showStep(6, 1000);
    clock.advance(400);
    clock.hold(true);
    clock.advance(1000);
    EXPECT_DOUBLE_EQ(clock.phase(), 0.4);
    EXPECT_TRUE(clock.moving());
    EXPECT_FALSE(clock.running());
    clock.hold(false);
    clock.advance(100);
    EXPECT_DOUBLE_EQ(clock.phase(), 0.5);
    clock.hold(true);
    clock.showStep(7, 1000);
    EXPECT_TRUE(clock.running());
    EXPECT_EQ(clock.operation(), 6);
}

TEST(OperationClock, JumpsShortOperationsAndRushedStepsShowStates) {
    OperationClock clock = at(5);
    clock.showStep(60, 1000);
    EXPECT_FALSE(clock.moving());
    EXPECT_EQ(clock.operation(), 59);
    clock.showStep(61, OperationClock::kLeastMs / 2);
    EXPECT_FALSE(clock.moving());
    clock.showStep(62, 1000);
    EXPECT_TRUE(clock.moving());
    clock.showStep(63, 1000);
    EXPECT_FALSE(clock.moving()) << "a key that repeats goes from state to state";
    clock.showStep(0, 1000);
    EXPECT_EQ(clock.phase(), 0) << "the empty machine is the begin of the first operation";
}

TEST(BedLayout, APlaceAndItsPixelsAreOne) {
    const BedLayout layout{QRectF(70, 0, 900, 300), 12.5, 21, 17};
    for (const double at : {-3.0, 0.0, 7.25, 40.0}) {
        EXPECT_NEAR(layout.pitchesAt(layout.xOf(at)), at, 1e-9);
    }
    EXPECT_LT(layout.rearNumbersY() + layout.textHeight, layout.vergeY(machine::Bed::Rear));
    EXPECT_LT(layout.vergeY(machine::Bed::Rear), layout.vergeY(machine::Bed::Front));
    EXPECT_LE(layout.frontNumbersY() + layout.textHeight, layout.area.bottom());
}

TEST(BedLayout, TheNeedleUnderAPointFollowsTheRacking) {
    const BedLayout layout{QRectF(70, 0, 900, 300), 12.5, 21, 17};
    const double rack = -1.25;
    for (const machine::Needle needle :
         {machine::Needle{machine::Bed::Front, 9}, machine::Needle{machine::Bed::Rear, 14}}) {
        const QPointF drawn = layout.at(needle.bed, machine::positionPitches(needle, rack), 0);
        EXPECT_EQ(layout.needleAt(drawn, rack), needle);
    }
}

TEST(PhaseText, SaysNothingAtRestAndSomethingWhileNeedlesMove) {
    using machine::OperationKind;
    for (const OperationKind kind : {OperationKind::Knit, OperationKind::Tuck, OperationKind::Split,
                                     OperationKind::Xfer, OperationKind::Drop, OperationKind::Rack}) {
        machine::Operation operation;
        operation.kind = kind;
        EXPECT_TRUE(phaseText(operation, 0, true).isEmpty());
        EXPECT_TRUE(phaseText(operation, 1, true).isEmpty());
        for (const double phase : {0.01, 0.3, 0.5, 0.58, 0.7, 0.95}) {
            EXPECT_FALSE(phaseText(operation, phase, true).isEmpty());
            EXPECT_FALSE(phaseText(operation, phase, false).contains("old loop"));
        }
    }
}

} // namespace
} // namespace knittsim::ui
