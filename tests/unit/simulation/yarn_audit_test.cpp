#include "core/fabric/fabric_builder.h"
#include "core/fabric/machine_shape.h"
#include "core/formats/formats.h"
#include "core/geometry/crossing_audit.h"
#include "core/pattern/swatch.h"
#include "core/simulation/yarn_settling.h"
#include "tests/support/machine_data.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <optional>

namespace knittsim::simulation {
namespace {

/// Of a program of a real machine; nothing without such programs.
std::optional<fabric::Fabric> realFabric(const std::filesystem::path& name) {
    const std::filesystem::path file = test::machineData() / name;
    if (!std::filesystem::exists(file)) {
        return std::nullopt;
    }
    const auto program = formats::readProgram(file);
    EXPECT_TRUE(program) << name;
    return program ? std::optional(
                         fabric::buildFabric(machine::Timeline(program.value(), machine::genericProfile())))
                   : std::nullopt;
}

/// Small programs of real machines, with tucks on both beds, splits, waste yarn and loops let go at the end.
class RealPrograms : public ::testing::TestWithParam<const char*> {};

TEST_P(RealPrograms, SettleWithoutAnyYarnGoingThroughAnother) {
    const auto f = realFabric(GetParam());
    if (!f) {
        GTEST_SKIP() << "no machine data";
    }
    YarnSettling settling(*f, {}, {});
    while (settling.step({})) {
    }
    const YarnAudit audit = settling.audit();
    EXPECT_EQ(audit.coreOverlaps, 0);
    EXPECT_EQ(audit.laidWrong.size(), 0U);
    EXPECT_EQ(audit.passages.size(), 0U);
    EXPECT_EQ(audit.laidCrossings, audit.expectedCrossings);
    EXPECT_GT(audit.expectedCrossings, 50U);
}

INSTANTIATE_TEST_SUITE_P(Files, RealPrograms,
                         ::testing::Values("kniterate-backend/position-keep.k",
                                           "kniterate-backend/position-center.k",
                                           "kniterate-backend/split.k"),
                         [](const auto& info) { return "File" + std::to_string(info.index); });

/// Plated: two yarns run side by side, and a chain of evenly spaced nodes alone would lose some crossings.
TEST(YarnAudit, ChainsKeepEveryCrossingOfACurve) {
    const auto f = realFabric("knittingutils/plating.k");
    if (!f) {
        GTEST_SKIP() << "no machine data";
    }
    const double loopLength = fabric::meanLoopLength(*f);
    YarnLayout layout;
    layout.nodesPerLoop = 36;
    layout.waleSpacingMm = loopLength / 4.1;
    layout.courseSpacingMm = loopLength / 5.3;
    const FabricYarns yarns = layYarns(*f, {}, layout);
    const geometry::YarnCurves laid = curvesOf(yarns, yarns.chains.start());
    const geometry::CrossingAudit audit =
        geometry::auditCrossings(*f, laid, geometry::projectCrossings(laid));
    EXPECT_EQ(audit.found, audit.expected);
    EXPECT_GT(audit.expected, 100'000U);
}

/// Curled as far as it goes: the shape alone no longer shows how its loops are knotted, the way to it does.
TEST(YarnAudit, KnowsOfACurledFabricThatNothingPassed) {
    const fabric::Fabric f =
        fabric::buildFabric(machine::Timeline(pattern::makePlain(10, 10), machine::genericProfile()));
    YarnSettling settling(f, {}, {.surroundings = Surroundings::Free});
    while (settling.step({})) {
    }
    const YarnAudit audit = settling.audit();
    EXPECT_GT(audit.foldedLoops, 0U);
    EXPECT_TRUE(audit.holds());
}

} // namespace
} // namespace knittsim::simulation
