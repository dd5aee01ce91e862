#include "core/simulation/settling_record.h"
#include "tests/unit/simulation/swatches.h"

#include <gtest/gtest.h>

namespace knittsim::simulation {
namespace {

double width(const SettlingShape& shape) {
    float low = 1e9F;
    float high = -1e9F;
    for (std::size_t i = 0; i < shape.positions.size(); i += 3) {
        low = std::min(low, shape.positions[i]);
        high = std::max(high, shape.positions[i]);
    }
    return high - low;
}

TEST(SettlingRecord, KeepsAShapeWhenItHasMovedFarEnough) {
    SettlingRecord record(0.5, 100);
    for (int i = 0; i <= 100; ++i) {
        const float x = 0.1F * static_cast<float>(i);
        std::vector<float> places{x, 0, 0, x + 1, 0, 0};
        if (record.wants(places)) {
            record.add({std::move(places)});
        }
    }
    // 10 mm in ways of at least half a millimetre, reached after five or six steps.
    EXPECT_GE(record.shapes().size(), 17U);
    EXPECT_LE(record.shapes().size(), 21U);
    EXPECT_EQ(record.shapes().front().positions[0], 0);
}

TEST(SettlingRecord, ALongWayIsThinnedOutEvenly) {
    SettlingRecord record(0.5, 10);
    for (int i = 0; i <= 1000; ++i) {
        std::vector<float> places{static_cast<float>(i), 0, 0};
        if (record.wants(places)) {
            record.add({std::move(places)});
        }
    }
    const auto& shapes = record.shapes();
    ASSERT_LE(shapes.size(), 20U);
    ASSERT_GE(shapes.size(), 8U);
    const float step = shapes[1].positions[0] - shapes[0].positions[0];
    for (std::size_t i = 1; i < shapes.size(); ++i) {
        EXPECT_NEAR(shapes[i].positions[0] - shapes[i - 1].positions[0], step, 0.51F * step);
    }
}

TEST(SettlingRecord, AFabricIsSeenToDrawIn) {
    const auto fabric = test::plain();
    const auto shapes = recordSettling(fabric, {}, {});
    ASSERT_TRUE(shapes);
    ASSERT_GE(shapes->size(), 10U);
    EXPECT_LT(width(shapes->back()), 0.9 * width(shapes->front()));
    // The last shape is the one at rest.
    Simulation simulation;
    simulation.apply(test::load(fabric));
    simulation.runToEnd(60);
    EXPECT_NEAR(width(shapes->back()), width({simulation.frame().positions}), 0.02 * width(shapes->back()));
}

TEST(SettlingRecord, CanBeCancelled) {
    int asked = 0;
    const auto shapes = recordSettling(test::plain(), {}, {}, [&asked](double share) {
        EXPECT_GE(share, 0);
        EXPECT_LT(share, 1);
        return ++asked < 3;
    });
    ASSERT_FALSE(shapes);
    EXPECT_EQ(shapes.diagnostics().front().id, "KS0009");
    EXPECT_EQ(asked, 3);
}

} // namespace
} // namespace knittsim::simulation
