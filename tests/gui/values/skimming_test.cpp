#include "core/pattern/samples.h"
#include "ui/views/step_player/skimming.h"

#include <gtest/gtest.h>

namespace knittsim::ui {
namespace {

using machine::Bed;
using machine::OperationKind;

constexpr double kSlow = 0.5;

machine::Program program(const std::vector<std::pair<OperationKind, Bed>>& operations) {
    machine::Program made;
    for (const auto& [kind, bed] : operations) {
        machine::Operation op;
        op.kind = kind;
        op.needle.bed = bed;
        made.operations.push_back(op);
    }
    return made;
}

TEST(Skimming, WhatIsNewIsWatchedWhatIsKnownGoesFast) {
    std::vector<std::pair<OperationKind, Bed>> operations(20, {OperationKind::Knit, Bed::Front});
    operations.emplace_back(OperationKind::Xfer, Bed::Front);
    operations.emplace_back(OperationKind::Rack, Bed::Front);
    operations.emplace_back(OperationKind::Xfer, Bed::Rear);
    const machine::Program knitted = program(operations);
    EXPECT_EQ(skimmingHaste(knitted, 0, kSlow), 1);
    EXPECT_EQ(skimmingHaste(knitted, 1, kSlow), 1);
    EXPECT_EQ(skimmingHaste(knitted, 2, kSlow), 3);
    EXPECT_EQ(skimmingHaste(knitted, 19, kSlow) * kSlow, kSkimmingSpeed);
    for (const int fresh : {20, 21, 22}) {
        EXPECT_EQ(skimmingHaste(knitted, fresh, kSlow), 1) << fresh;
    }
}

TEST(Skimming, WhatIsForgottenIsNewAgain) {
    std::vector<std::pair<OperationKind, Bed>> operations(4, {OperationKind::Tuck, Bed::Rear});
    operations.insert(operations.end(), 17, {OperationKind::Knit, Bed::Front});
    operations.emplace_back(OperationKind::Tuck, Bed::Rear);
    EXPECT_EQ(skimmingHaste(program(operations), 21, kSlow), 1);
}

TEST(Skimming, NothingGetsSlowerAndNothingOutsideMatters) {
    const machine::Program knitted =
        program(std::vector<std::pair<OperationKind, Bed>>(20, {OperationKind::Knit, Bed::Front}));
    EXPECT_EQ(skimmingHaste(knitted, 19, 50), 1);
    EXPECT_EQ(skimmingHaste(knitted, 3, 8), 1.25);
    EXPECT_EQ(skimmingHaste(knitted, -1, kSlow), 1);
    EXPECT_EQ(skimmingHaste(knitted, 20, kSlow), 1);
}

/// With each new thing at two seconds an operation.
TEST(Skimming, TheTransferDemoTakesAQuarterOfItsTime) {
    const machine::Program demo = pattern::makeSample("transfer-demo");
    double seconds = 0;
    for (int i = 0; i < static_cast<int>(demo.operations.size()); ++i) {
        seconds += 1 / (kSlow * skimmingHaste(demo, i, kSlow));
    }
    const double plain = static_cast<double>(demo.operations.size()) / kSlow;
    EXPECT_LT(seconds, plain / 4);
    EXPECT_GT(seconds, plain / 20);
}

} // namespace
} // namespace knittsim::ui
