#include "core/machine/timeline.h"
#include "tests/support/build.h"
#include "tests/support/random_program.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

namespace knittsim::machine {
namespace {

std::vector<std::uint64_t> digestsForward(const Timeline& timeline) {
    Emulator emulator(timeline.program(), timeline.profile());
    std::vector<std::uint64_t> digests{digest(emulator.state())};
    while (!emulator.atEnd()) {
        emulator.step();
        digests.push_back(digest(emulator.state()));
    }
    return digests;
}

class RandomTimeline : public testing::TestWithParam<unsigned> {
protected:
    Timeline m_timeline{test::randomProgram({.seed = GetParam(), .operations = 3000}), genericProfile()};
};

TEST_P(RandomTimeline, AnyMomentIsTheOneReachedByGoingForward) {
    const auto digests = digestsForward(m_timeline);
    std::vector<OperationIndex> order(digests.size());
    std::iota(order.begin(), order.end(), 0);
    std::shuffle(order.begin(), order.end(), std::mt19937(GetParam()));
    order.resize(200);
    for (const OperationIndex k : order) {
        ASSERT_EQ(digest(m_timeline.stateAfter(k)), digests[static_cast<std::size_t>(k)]) << "after " << k;
    }
}

TEST_P(RandomTimeline, EveryLoopIsOnOneNeedleDrawnThroughOrDropped) {
    struct Drops : EmulationListener {
        std::vector<LoopIndex> loops;
        void loopsDropped(Needle, std::span<const LoopIndex> dropped) override {
            loops.insert(loops.end(), dropped.begin(), dropped.end());
        }
    } drops;
    Emulator emulator(m_timeline.program(), m_timeline.profile());
    while (!emulator.atEnd()) {
        emulator.step(&drops);
    }
    const LoopTable& table = emulator.loops();
    enum Fate : char { Lost, Bound, Dropped, Held };
    std::vector<char> fate(table.loops.size(), Lost);
    for (std::size_t i = 0; i < table.loops.size(); ++i) {
        for (const LoopIndex parent : table.parentsOf(static_cast<LoopIndex>(i))) {
            ASSERT_LT(static_cast<std::size_t>(parent), i);
            fate[static_cast<std::size_t>(parent)] = Bound;
        }
    }
    for (const LoopIndex loop : drops.loops) {
        fate[static_cast<std::size_t>(loop)] = Dropped;
    }
    for (const NeedleRow& row : emulator.state().beds) {
        for (std::int32_t n = row.first(); n < row.end(); ++n) {
            for (const LoopIndex loop : row.at(n)) {
                ASSERT_NE(fate[static_cast<std::size_t>(loop)], Held) << "on two needles";
                fate[static_cast<std::size_t>(loop)] = Held;
            }
        }
    }
    EXPECT_EQ(std::ranges::count(fate, Lost), 0);
    EXPECT_EQ(static_cast<std::size_t>(emulator.state().loopCount), table.loops.size());
}

TEST_P(RandomTimeline, YarnFedIsTheLoopsPlusTheFloats) {
    std::vector<double> fed(static_cast<std::size_t>(m_timeline.finalState().yarnCount), 0);
    for (const Loop& loop : m_timeline.loops().loops) {
        double& sum = fed[static_cast<std::size_t>(loop.yarn)];
        sum += loop.lengthMm + loop.floatMm;
        ASSERT_NEAR(loop.yarnEndMm, sum, 1e-6);
    }
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomTimeline, testing::Range(1U, 13U));

TEST(Timeline, KeepsABoundedNumberOfKeyframes) {
    const Timeline timeline(test::randomProgram({.seed = 7, .operations = 60000}), genericProfile());
    EXPECT_LE(timeline.keyframeCount(), 131U);
}

TEST(Timeline, CountsOutsideTheProgramAreClamped) {
    const Timeline timeline = test::timeline("in 1\nknit + f0 1\n");
    EXPECT_EQ(timeline.stateAfter(-5).nextOperation, 0);
    EXPECT_EQ(timeline.stateAfter(99).nextOperation, 2);
    EXPECT_EQ(timeline.stateAfter(2), timeline.finalState());
}

TEST(Timeline, AnEmptyProgramHasAnEmptyMachine) {
    const Timeline timeline(Program{}, genericProfile());
    EXPECT_EQ(timeline.stateAfter(0).loopCount, 0);
}

TEST(Timeline, FindingsAreBounded) {
    std::string lines;
    for (int i = 0; i < 3000; ++i) {
        lines += "out 1\n";
    }
    const Timeline timeline = test::timeline(lines);
    EXPECT_EQ(timeline.diagnostics().size(), 1001U);
    EXPECT_EQ(timeline.diagnostics().back().id, "KS0211");
}

} // namespace
} // namespace knittsim::machine
