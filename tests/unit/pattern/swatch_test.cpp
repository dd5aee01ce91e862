#include "core/pattern/swatch.h"
#include "knitted.h"

namespace knittsim::pattern {
namespace {

using machine::Bed;
using machine::Loop;
using machine::LoopIndex;
using machine::OperationKind;
using machine::Program;
using machine::Timeline;

/// wales x courses loops: the first course hangs on empty needles, every other loop goes through exactly the
/// loop of its own wale in the course below, and the last course stays on the needles.
void expectRegular(const Program& program, int wales, int courses) {
    const Timeline timeline = knitted(program);
    const std::vector<Loop>& loops = timeline.loops().loops;
    ASSERT_EQ(loops.size(), static_cast<std::size_t>(wales * courses));
    for (std::size_t i = 0; i < loops.size(); ++i) {
        const auto parents = timeline.loops().parentsOf(static_cast<LoopIndex>(i));
        if (i < static_cast<std::size_t>(wales)) {
            ASSERT_TRUE(parents.empty());
            continue;
        }
        ASSERT_EQ(parents.size(), 1U);
        const auto parent = static_cast<std::size_t>(parents[0]);
        EXPECT_EQ(parent / static_cast<std::size_t>(wales), i / static_cast<std::size_t>(wales) - 1);
        EXPECT_EQ(loops[parent].needle.index, loops[i].needle.index);
    }
    int held = 0;
    for (int needle = 1; needle <= wales; ++needle) {
        held += static_cast<int>(timeline.finalState().loopsOn({Bed::Front, needle}).size() +
                                 timeline.finalState().loopsOn({Bed::Rear, needle}).size());
    }
    EXPECT_EQ(held, wales);
}

TEST(Swatch, EveryCourseGoesThroughTheOneBelow) {
    expectRegular(makePlain(7, 5), 7, 5);
    expectRegular(makeRib(8, 6), 8, 6);
    expectRegular(makeRib(10, 4, 2, 2), 10, 4);
    expectRegular(makeGarter(5, 6), 5, 6);
    expectRegular(makeSeed(6, 7), 6, 7);
    expectRegular(makeMoss(6, 8), 6, 8);
    expectRegular(makePlain(1, 1), 1, 1);
}

TEST(Swatch, TransfersWhereAWaleChangesBeds) {
    EXPECT_EQ(count(makePlain(9, 9), OperationKind::Xfer), 0);
    EXPECT_EQ(count(makeRib(9, 9), OperationKind::Xfer), 0);
    EXPECT_EQ(count(makeGarter(9, 5), OperationKind::Xfer), 9 * 4);
    EXPECT_EQ(count(makeSeed(9, 5), OperationKind::Xfer), 9 * 4);
    EXPECT_EQ(count(makeMoss(9, 8), OperationKind::Xfer), 9 * 3);
}

TEST(Swatch, RibWalesStayOnTheirBed) {
    const Program program = makeRib(10, 3, 3, 2);
    for (const machine::Operation& op : program.operations) {
        if (op.kind == OperationKind::Knit) {
            EXPECT_EQ(op.needle.bed, (op.needle.index - 1) % 5 < 3 ? Bed::Front : Bed::Rear);
        }
    }
}

TEST(Swatch, LargestSwatch) {
    EXPECT_EQ(count(makePlain(500, 500), OperationKind::Knit), 250'000);
    EXPECT_EQ(count(makeSeed(500, 500), OperationKind::Xfer), 500 * 499);
}

} // namespace
} // namespace knittsim::pattern
