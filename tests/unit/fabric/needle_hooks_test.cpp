#include "core/fabric/fabric_builder.h"
#include "core/fabric/machine_shape.h"
#include "core/fabric/needle_hooks.h"
#include "core/pattern/samples.h"

#include <gtest/gtest.h>

namespace knittsim::fabric {
namespace {

struct Hung {
    Fabric fabric;
    std::vector<float> positions;
    std::vector<NeedleHook> hooks;
};

Hung hang(const machine::Timeline& timeline, OperationIndex count) {
    Hung hung{buildFabric(timeline, count), {}, {}};
    hung.positions = machinePlaces(hung.fabric);
    hung.hooks =
        hangOnNeedles(hung.fabric, heldStacks(timeline.stateAfter(count)),
                      &timeline.program().operations[static_cast<std::size_t>(count) - 1], hung.positions);
    return hung;
}

Vec3f headOf(const Hung& hung, LoopIndex loop) {
    const PointIndex head = hung.fabric.loops[static_cast<std::size_t>(loop)].headLeft;
    const auto entry = static_cast<std::size_t>(hung.fabric.points[static_cast<std::size_t>(head)].entry);
    return {hung.positions[3 * entry], hung.positions[3 * entry + 1], hung.positions[3 * entry + 2]};
}

const NeedleHook* find(const Hung& hung, Needle needle) {
    const auto found = std::ranges::find(hung.hooks, needle, &NeedleHook::needle);
    return found == hung.hooks.end() ? nullptr : &*found;
}

TEST(NeedleHooks, EveryHeldLoopHangsAtItsNeedleAndNothingElseMoves) {
    const machine::Timeline timeline(pattern::makeSample("cable-left"), machine::genericProfile());
    for (OperationIndex count = 40; count < timeline.operationCount(); count += 37) {
        const Hung hung = hang(timeline, count);
        const machine::MachineState state = timeline.stateAfter(count);
        std::size_t needles = 0;
        std::vector<bool> moved(hung.positions.size() / 3, false);
        for (const HeldStack& stack : heldStacks(state)) {
            ++needles;
            const NeedleHook* hook = find(hung, stack.needle);
            ASSERT_TRUE(hook);
            for (const LoopIndex loop : stack.loops) {
                const Vec3f head = headOf(hung, loop);
                EXPECT_NEAR(head.y(), hook->place.y(), 1e-4);
                EXPECT_NEAR(head.x(), hook->place.x(), 0.5 * hung.fabric.pitchMm);
                EXPECT_EQ(hook->shaft.z() > 0, machine::isFront(stack.needle.bed));
                const Loop& made = hung.fabric.loops[static_cast<std::size_t>(loop)];
                for (const PointIndex p : {made.headLeft, made.headRight}) {
                    moved[static_cast<std::size_t>(hung.fabric.points[static_cast<std::size_t>(p)].entry)] =
                        true;
                }
            }
        }
        EXPECT_EQ(needles, hung.hooks.size());
        for (std::size_t entry = 0; entry < moved.size(); ++entry) {
            if (!moved[entry]) {
                EXPECT_FLOAT_EQ(hung.positions[3 * entry],
                                static_cast<float>(hung.fabric.machinePositions[entry].x()));
            }
        }
    }
}

TEST(NeedleHooks, ARackedBedTakesItsLoopsAsideAndTheTransferIsMarked) {
    const machine::Timeline timeline(pattern::makeSample("cable-left"), machine::genericProfile());
    const auto& operations = timeline.program().operations;
    const auto rack = std::ranges::find_if(operations, [](const machine::Operation& op) {
        return op.kind == machine::OperationKind::Rack && op.value != 0;
    });
    ASSERT_NE(rack, operations.end());
    const auto count = static_cast<OperationIndex>(rack - operations.begin());
    const Hung before = hang(timeline, count);
    const Hung after = hang(timeline, count + 1);
    int rear = 0;
    for (const NeedleHook& hook : after.hooks) {
        const NeedleHook* was = find(before, hook.needle);
        ASSERT_TRUE(was);
        const double moved = static_cast<double>(hook.place.x() - was->place.x());
        if (machine::isFront(hook.needle.bed)) {
            EXPECT_NEAR(moved, 0, 1e-4);
        } else {
            ++rear;
            EXPECT_GT(moved * rack->value, 0);
        }
    }
    EXPECT_GT(rear, 0);
    const auto transfer = std::find_if(rack, operations.end(), [](const machine::Operation& op) {
        return op.kind == machine::OperationKind::Xfer;
    });
    const Hung done = hang(timeline, static_cast<OperationIndex>(transfer - operations.begin()) + 1);
    ASSERT_TRUE(find(done, transfer->target));
    EXPECT_TRUE(find(done, transfer->target)->works);
    EXPECT_EQ(std::ranges::count_if(done.hooks, &NeedleHook::works), 1);
}

/// Short rows end many courses below the needles on one side: the fabric is lifted there, wale by wale.
TEST(NeedleHooks, WhereFewerCoursesAreKnittedTheFabricIsLifted) {
    const machine::Timeline timeline(pattern::makeSample("short-rows"), machine::genericProfile());
    double most = 0;
    for (OperationIndex count = 60; count < timeline.operationCount(); count += 41) {
        const Fabric fabric = buildFabric(timeline, count);
        const auto height = [&fabric](PointIndex point, const std::vector<float>& at) {
            return at[3 * static_cast<std::size_t>(fabric.points[static_cast<std::size_t>(point)].entry) + 1];
        };
        // As after settling: no loop is longer than a course, wherever its needle is.
        std::vector<float> settled = machinePlaces(fabric);
        const auto stacks = heldStacks(timeline.stateAfter(count));
        std::vector<Loop> held;
        for (const HeldStack& stack : stacks) {
            for (const LoopIndex index : stack.loops) {
                const Loop& loop = fabric.loops[static_cast<std::size_t>(index)];
                if (loop.footLeft < 0) {
                    continue; // a tuck has none
                }
                held.push_back(loop);
                for (const PointIndex head : {loop.headLeft, loop.headRight}) {
                    const auto entry =
                        static_cast<std::size_t>(fabric.points[static_cast<std::size_t>(head)].entry);
                    settled[3 * entry + 1] =
                        height(loop.footLeft, settled) + static_cast<float>(fabric.pitchMm);
                }
            }
        }
        std::vector<float> hung = settled;
        hangOnNeedles(fabric, stacks, nullptr, hung);
        for (const Loop& loop : held) {
            EXPECT_LT(height(loop.headLeft, hung) - height(loop.footLeft, hung), 6 * fabric.pitchMm);
            most = std::max(
                most, static_cast<double>(height(loop.footLeft, hung) - height(loop.footLeft, settled)));
        }
    }
    EXPECT_GT(most, 10); // mm: without the lift a loop would be drawn so much too long
}

TEST(NeedleHooks, AnEmptyMachineHasNone) {
    std::vector<float> none;
    EXPECT_TRUE(hangOnNeedles(Fabric(), {}, nullptr, none).empty());
}

} // namespace
} // namespace knittsim::fabric
