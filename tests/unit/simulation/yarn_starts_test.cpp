#include "core/geometry/measure.h"
#include "core/simulation/yarn_settling.h"
#include "swatches.h"

#include <gtest/gtest.h>

namespace knittsim::simulation {
namespace {

struct Rest {
    geometry::Measurement inner;
    YarnAudit audit;
    physics::YarnRelaxReport report;
};

Rest settleFrom(const fabric::Fabric& f, double wider, double higher) {
    YarnSettling::Options options;
    options.layout.wider = wider;
    options.layout.higher = higher;
    YarnSettling settling(f, {}, options);
    while (settling.step({})) {
    }
    const std::vector<float> places = entryPositions(f, settling.yarns(), settling.shape());
    const geometry::Measurement whole = geometry::measure(f, places);
    return {geometry::measure(f, places, {2, whole.wales - 3, 2, whole.courses - 3}), settling.audit(),
            settling.report()};
}

/// However its yarns were laid, a fabric comes to one size, with all forces in balance.
TEST(YarnStarts, PlainComesToOneRestFromTwoOfThem) {
    const auto f = test::plain(10, 10);
    const Rest wide = settleFrom(*f, 1.12, 0.95);
    const Rest narrow = settleFrom(*f, 0.94, 1.1);
    for (const Rest& rest : {wide, narrow}) {
        EXPECT_EQ(rest.report.verdict, physics::StopRule::Verdict::ResidualReached);
        EXPECT_LE(rest.report.residual, 1e-3);
        EXPECT_TRUE(rest.audit.holds());
    }
    EXPECT_NEAR(wide.inner.waleSpacingMm / narrow.inner.waleSpacingMm, 1, 0.01);
    EXPECT_NEAR(wide.inner.courseSpacingMm / narrow.inner.courseSpacingMm, 1, 0.01);
}

} // namespace
} // namespace knittsim::simulation
