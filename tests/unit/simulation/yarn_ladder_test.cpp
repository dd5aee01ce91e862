#include "core/fabric/fabric_builder.h"
#include "core/fabric/reduction.h"
#include "core/pattern/swatch.h"
#include "core/simulation/yarn_settling.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace knittsim::simulation {
namespace {

using physics::Entry;

constexpr int kSide = 10;
constexpr int kNeedle = 5;

/// Plain knit; one loop of the last course is let go on the machine.
fabric::Fabric droppedFabric() {
    machine::Program program = pattern::makePlain(kSide, kSide);
    machine::Operation drop;
    drop.kind = machine::OperationKind::Drop;
    drop.needle = {machine::Bed::Front, kNeedle};
    program.operations.push_back(drop);
    return fabric::buildFabric(machine::Timeline(std::move(program), machine::genericProfile()));
}

double yarnOf(const physics::YarnChains& chains) {
    double sum = 0;
    for (const physics::Chain& chain : chains.chains) {
        for (Entry i = 0; i < chain.segmentCount(); ++i) {
            sum += chains.restLength[static_cast<std::size_t>(chain.first + i)];
        }
    }
    return sum;
}

double lengthOf(const physics::YarnChains& chains, const physics::Vector& x) {
    double sum = 0;
    for (const physics::Chain& chain : chains.chains) {
        for (Entry e = chain.first; e + 1 < chain.first + chain.count; ++e) {
            sum += (physics::at(x, e + 1) - physics::at(x, e)).norm();
        }
    }
    return sum;
}

class YarnLadder : public ::testing::Test {
protected:
    static void SetUpTestSuite() {
        const fabric::Fabric whole = droppedFabric();
        const fabric::Runs runs = fabric::findRuns(whole);
        s_run = runs.loopCount();
        s_whole = new fabric::Fabric(whole);
        s_fabric = new fabric::Fabric(fabric::removeRuns(whole, runs).fabric);
        s_settling = new YarnSettling(*s_fabric, {}, {});
        while (s_settling->step({})) {
        }
    }
    static void TearDownTestSuite() {
        delete s_settling;
        delete s_fabric;
        delete s_whole;
    }

    static Eigen::Vector3d placeOf(fabric::PointIndex point) {
        const Entry node = s_settling->yarns().nodeOfPoint[static_cast<std::size_t>(point)];
        return physics::at(s_settling->shape(), node);
    }
    static const fabric::Loop* loopAt(int needle, int course) {
        for (std::size_t i = 0; i < s_fabric->loops.size(); ++i) {
            const fabric::Loop& loop = s_fabric->loops[i];
            if (s_fabric->made.loops[i].needle.index == needle && loop.course == course &&
                loop.headLeft >= 0) {
                return &loop;
            }
        }
        return nullptr;
    }

    inline static std::size_t s_run = 0;
    inline static fabric::Fabric* s_whole = nullptr;
    inline static fabric::Fabric* s_fabric = nullptr;
    inline static YarnSettling* s_settling = nullptr;
};

TEST_F(YarnLadder, ComesToRestWithoutAnyYarnInOrThroughAnother) {
    EXPECT_EQ(s_run, static_cast<std::size_t>(kSide));
    EXPECT_EQ(s_settling->phase(), YarnSettling::Phase::Done);
    const YarnAudit audit = s_settling->audit();
    EXPECT_TRUE(audit.holds());
    EXPECT_EQ(audit.laidCrossings, audit.expectedCrossings);
}

/// The yarn of the loops that ran is still there: it went into the rungs and their neighbours.
TEST_F(YarnLadder, KeepsAllItsYarn) {
    const double fed = std::accumulate(s_whole->lengths.begin(), s_whole->lengths.end(), 0.0);
    const FabricYarns& yarns = s_settling->yarns();
    EXPECT_NEAR(yarnOf(yarns.chains) * yarns.units.lengthMm / fed, 1, 0.02);
    EXPECT_NEAR(lengthOf(yarns.chains, s_settling->shape()) / yarnOf(yarns.chains), 1, 0.01);
}

/// Yarn of a rung moves freely to the loops beside it, which grow: the gap is wider than the stitches are
/// apart, and no loop holds together what is left.
TEST_F(YarnLadder, OpensAGapThatRungsSpan) {
    double gap = 0;
    double spacing = 0;
    int courses = 0;
    for (int course = 2; course + 2 < kSide; ++course) {
        EXPECT_EQ(loopAt(kNeedle, course), nullptr);
        const fabric::Loop* left = loopAt(kNeedle - 1, course);
        const fabric::Loop* right = loopAt(kNeedle + 1, course);
        const fabric::Loop* farRight = loopAt(kNeedle + 3, course);
        ASSERT_TRUE(left != nullptr && right != nullptr && farRight != nullptr);
        gap += placeOf(right->headLeft).x() - placeOf(left->headRight).x();
        const fabric::Loop* next = loopAt(kNeedle + 2, course);
        ASSERT_NE(next, nullptr);
        spacing += placeOf(farRight->headLeft).x() - placeOf(next->headRight).x();
        ++courses;
    }
    EXPECT_GT(gap / courses, 1.5 * std::abs(spacing / courses));
}

} // namespace
} // namespace knittsim::simulation
