#include "core/formats/knitout/writer.h"
#include "tests/support/build.h"
#include "tests/support/random_program.h"
#include "tests/support/shrink.h"

#include <gmock/gmock.h>

#include <algorithm>

namespace knittsim::test {
namespace {

using machine::Operation;
using machine::OperationKind;
using machine::Program;
using testing::HasSubstr;

std::vector<OperationKind> kinds(const Program& program) {
    std::vector<OperationKind> all;
    for (const Operation& op : program.operations) {
        all.push_back(op.kind);
    }
    return all;
}

bool has(const Program& program, OperationKind kind) {
    return std::ranges::any_of(program.operations, [&](const Operation& op) { return op.kind == kind; });
}

// The known smallest program: a split needs its carrier brought in, and its rack if its needles need one.
TEST(Shrink, FindsTheSmallestFailingProgram) {
    const auto fails = [](const Program& p) { return has(p, OperationKind::Split); };
    int failing = 0;
    for (std::uint32_t seed = 1; seed <= 10; ++seed) {
        const Program program = randomProgram({.seed = seed});
        if (fails(program)) {
            ++failing;
            const Program least = shrink(program, fails);
            EXPECT_TRUE(isValid(least));
            const Operation& split = least.operations.back();
            EXPECT_THAT(kinds(least),
                        testing::ElementsAreArray(
                            split.needle.index == split.target.index
                                ? std::vector{OperationKind::In, OperationKind::Split}
                                : std::vector{OperationKind::In, OperationKind::Rack, OperationKind::Split}));
        }
    }
    EXPECT_GT(failing, 5);
}

TEST(Shrink, KeepsWhatBelongsTogether) {
    // A transfer at a rack other than 0, which is valid only behind that rack.
    const auto fails = [](const Program& p) {
        return std::ranges::any_of(p.operations, [](const Operation& op) {
            return op.kind == OperationKind::Xfer && op.needle.index != op.target.index;
        });
    };
    const Program program = randomProgram({.seed = 3});
    ASSERT_TRUE(fails(program));
    EXPECT_THAT(kinds(shrink(program, fails)),
                testing::ElementsAre(OperationKind::Rack, OperationKind::Xfer));
}

TEST(Shrink, TakesOutWholePassesAndSingleOperations) {
    // Three knits of carrier 2 anywhere: everything else goes.
    const auto fails = [](const Program& p) {
        return std::ranges::count_if(p.operations, [](const Operation& op) {
                   return op.kind == OperationKind::Knit && op.carriers.contains(1);
               }) >= 3;
    };
    const Program least = shrink(randomProgram({.seed = 5}), fails);
    EXPECT_EQ(std::ranges::count(kinds(least), OperationKind::Knit), 3);
    EXPECT_LE(least.operations.size(), 5U) << "three knits and the carriers that they need";
}

TEST(Shrink, ShowsTheProgramAsKnitout) {
    const std::string text = explainFailure(randomProgram({.seed = 1}), [](const Program& p) {
        return has(p, OperationKind::Split) ? "there is a split" : "";
    });
    EXPECT_THAT(text, HasSubstr("there is a split"));
    EXPECT_THAT(text, HasSubstr(";!knitout-2"));
    EXPECT_THAT(text, HasSubstr("split "));
    EXPECT_EQ(std::ranges::count(text, '\n'), 6) << text;
}

TEST(Shrink, SaysNothingWhenAllIsWell) {
    EXPECT_EQ(explainFailure(randomProgram({.seed = 1}), [](const Program&) { return std::string(); }), "");
}

} // namespace
} // namespace knittsim::test
